/* win_active.c - epochs in which the target takes part: from fence to fence; or from start to complete at the
 * ranks that access, and from post to wait at those that are accessed. These serve accesses by a task, in any
 * call that waits: a rank that is accessed may itself wait for another. */
#include <stdlib.h>
#include "tasks.h"
#include "wins.h"

/* --- accesses that wait for the end of their epoch --- */

bool active_may(const struct win *w, int rank)
{
    return w->started ? group_rank_of(w->started, win_node(w, rank)) >= 0 : w->fenced;
}

void active_keep(struct win *w, const struct access *a)
{
    struct access *kept = get_memory(sizeof *kept);
    *kept = *a, kept->next = NULL;
    type_keep(a->type);
    type_keep(a->as);
    type_keep(a->their_type);
    *w->last_kept = kept;
    w->last_kept = &kept->next;
}

static void send_kept(struct win *w, int call, size_t most)
{
    while (w->kept) {
        struct access *a = w->kept;
        w->kept = a->next;
        a->call = call;
        access_send(w, a, ACCESS, most);
        type_leave(a->type);
        type_leave(a->as);
        type_leave(a->their_type);
        free(a);
    }
    w->last_kept = &w->kept;
}

/* Waits for the next message, and carries it out. */
static void take(struct win *w, int call)
{
    struct nxm_envelope e = {call, ACCESS, -1, w->comm->context};
    struct nxm_status s;
    do {
        if (tasks_under_way)
            tasks_go_on(call);
    } while (!nxm_probe(&e, !tasks_under_way, &s));
    char *message = get_memory((size_t)s.bytes);
    e.node = s.node;
    nxm_recv(&e, message, s.bytes, &s);
    access_carry_out(w, message, s.node);
    free(message);
}

/* --- fence --- */

/* Each learns how many messages there are for it. */
CALL(Win_fence, (int assert, MPI_Win win))
{
    struct win *w = win_of(win);
    if (!w)
        return fail_no_win(CALL_Win_fence);
    int code = win_check_idle(w, CALL_Win_fence);
    if (code)
        return code;
    w->fenced = !(assert &MPI_MODE_NOSUCCEED);
    if (assert & MPI_MODE_NOPRECEDE)
        return MPI_SUCCESS;
    const struct coll o = coll_of(w->comm, CALL_Win_fence);
    int *counts = get_memory((size_t)o.size * sizeof *counts), own = 0;
    for (int i = 0; i < o.size; i++)
        counts[i] = 0;
    for (const struct access *a = w->kept; a; a = a->next)
        counts[a->rank] += access_messages(a);
    coll_sum_for_each(&o, counts, &own);
    free(counts);
    send_kept(w, CALL_Win_fence, SIZE_MAX);
    while (own-- > 0)
        take(w, CALL_Win_fence);
    access_wait(w, CALL_Win_fence, -1);
    return MPI_SUCCESS;
}

/* --- start, complete --- */

static int wrong_group(struct win *w, int call, const struct group *busy, const struct group *g)
{
    return fail_win(w, call, busy ? MPI_ERR_RMA_SYNC : MPI_ERR_GROUP, "%s",
                    busy ? "such an epoch goes on already"
                    : g  ? "the group is not a part of the window's"
                         : "the group is null, or freed");
}

static bool is_wrong(const struct win *w, const struct group *busy, const struct group *g)
{
    bool wrong = busy || !g;
    for (int i = 0; !wrong && i < g->size; i++)
        wrong = group_rank_of(w->comm->local, group_node(g, i)) == MPI_UNDEFINED;
    return wrong;
}

CALL(Win_start, (MPI_Group group, int assert, MPI_Win win))
{
    struct win *w = win_of(win);
    struct group *g = group_of(group);
    if (!w)
        return fail_no_win(CALL_Win_start);
    if (is_wrong(w, w->started, g))
        return wrong_group(w, CALL_Win_start, w->started, g);
    w->started = group_keep(g);
    for (int i = 0; i < g->size && !(assert &MPI_MODE_NOCHECK); i++) {
        const struct nxm_envelope e = {CALL_Win_start, TOKEN, group_node(g, i), w->comm->context};
        struct nxm_status s;
        tasks_receive(&e, NULL, 0, &s);
    }
    return MPI_SUCCESS;
}

CALL(Win_complete, (MPI_Win win))
{
    struct win *w = win_of(win);
    if (!w)
        return fail_no_win(CALL_Win_complete);
    if (!w->started)
        return fail_win(w, CALL_Win_complete, MPI_ERR_RMA_SYNC, "no epoch of MPI_Win_start goes on");
    send_kept(w, CALL_Win_complete, MOST_BYTES - sizeof(struct win_head));
    for (int i = 0; i < w->started->size; i++)
        win_tell_pending(w, group_node(w->started, i), ACCESS,
                         (struct win_head){.what = DONE, .call = CALL_Win_complete});
    access_wait(w, CALL_Win_complete, -1);
    group_leave(w->started);
    w->started = NULL;
    return MPI_SUCCESS;
}

/* --- post, wait --- */

/* A task: carries out what comes, until all ranks of the epoch have completed. */
static int serve(struct args *a)
{
    struct win *w = a->into;
    const struct nxm_envelope e = {CALL_Win_post, ACCESS, -1, w->comm->context};
    char *message = get_memory(MOST_BYTES);
    while (w->missing) {
        struct nxm_status s;
        int id = (int)nxm_irecv(&e, message, MOST_BYTES);
        tasks_complete(&(struct nxm_completion){CALL_Win_post, NXM_WAIT, 1, &id, &s});
        if (((struct win_head *)message)->what == DONE)
            w->missing--;
        else
            access_carry_out(w, message, s.node);
    }
    free(message);
    return MPI_SUCCESS;
}

CALL(Win_post, (MPI_Group group, int assert, MPI_Win win))
{
    struct win *w = win_of(win);
    struct group *g = group_of(group);
    if (!w)
        return fail_no_win(CALL_Win_post);
    if (is_wrong(w, w->posted, g))
        return wrong_group(w, CALL_Win_post, w->posted, g);
    w->posted = group_keep(g);
    w->missing = g->size;
    for (int i = 0; i < g->size && !(assert &MPI_MODE_NOCHECK); i++) {
        const struct nxm_envelope e = {CALL_Win_post, TOKEN, group_node(g, i), w->comm->context};
        nxm_send(&e, NULL, 0, false);
    }
    w->exposure = task_start(serve, &(struct args){.into = w});
    return MPI_SUCCESS;
}

static int check_posted(struct win *w, int call)
{
    if (!w)
        return fail_no_win(call);
    return w->posted ? MPI_SUCCESS : fail_win(w, call, MPI_ERR_RMA_SYNC, "no epoch of MPI_Win_post goes on");
}

static void end_exposure(struct win *w)
{
    task_end(w->exposure);
    group_leave(w->posted);
    w->posted = NULL;
}

CALL(Win_wait, (MPI_Win win))
{
    struct win *w = win_of(win);
    int code = check_posted(w, CALL_Win_wait);
    if (code)
        return code;
    tasks_wait(CALL_Win_wait, w->exposure);
    end_exposure(w);
    return MPI_SUCCESS;
}

CALL(Win_test, (MPI_Win win, int *flag))
{
    struct win *w = win_of(win);
    int code = check_posted(w, CALL_Win_test);
    if (code)
        return code;
    tasks_go_on(CALL_Win_test);
    *flag = task_is_done(w->exposure);
    if (*flag)
        end_exposure(w);
    return MPI_SUCCESS;
}
