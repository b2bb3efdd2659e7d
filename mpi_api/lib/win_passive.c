/* win_passive.c - epochs in which the target does not take part: a rank locks another's window, accesses it,
 * and unlocks it. The target serves locks and accesses by a handler, which interrupts its program. */
#include <stdlib.h>
#include <string.h>
#include "nx.h"
#include "tasks.h"
#include "wins.h"

/* --- the target --- */

struct waiting {
    int node, kind;
};

struct win_server {
    struct win *win;
    int holders, kind; /* kind: of their lock */
    int waits;         /* so many wait, the first first */
    struct waiting *waiting;
    char message[MOST_BYTES] __attribute__((aligned(16)));
};

static void answer(const struct win_server *s, int call, int node)
{
    const struct nxm_envelope e = {call, ANSWER, node, s->win->comm->context};
    nxm_send(&e, NULL, 0, false);
}

static bool may_have(const struct win_server *s, int kind)
{
    return !s->holders || (kind == MPI_LOCK_SHARED && s->kind == MPI_LOCK_SHARED);
}

/* The lock goes to those who wait for it, in order, as far as it can. */
static void hand_over(struct win_server *s, int call)
{
    int done = 0;
    for (; done < s->waits && may_have(s, s->waiting[done].kind); done++) {
        s->holders++, s->kind = s->waiting[done].kind;
        answer(s, call, s->waiting[done].node);
    }
    s->waits -= done;
    memmove(s->waiting, s->waiting + done, (size_t)s->waits * sizeof *s->waiting);
}

static void carry_out(struct win_server *s, int node)
{
    const struct win_head head = *(const struct win_head *)s->message;
    if (head.what == LOCK)
        s->waiting[s->waits++] = (struct waiting){node, head.kind};
    if (head.what == UNLOCK)
        s->holders--;
    if (head.what == LOCK || head.what == UNLOCK)
        hand_over(s, head.call);
    if (head.what == MOVE || head.what == COMPARE)
        access_carry_out(s->win, s->message, node);
    else if (head.what != LOCK)
        answer(s, head.call, node);
}

static void serve(long type, long count, long node, long context, long server)
{
    struct win_server *s = (struct win_server *)server;
    (void)type, (void)count;
    if (((struct win_head *)s->message)->what == END) {
        free(s->waiting);
        free(s);
        return;
    }
    carry_out(s, (int)node);
    hrecvx(ASK, s->message, MOST_BYTES, -1, context, serve, server);
}

/* The hint no_locks says that no rank will ask. */
void passive_begin(struct win *w)
{
    char value[8] = "";
    int flag = 0;
    if (w->info != MPI_INFO_NULL)
        PMPI_Info_get(w->info, "no_locks", sizeof value - 1, value, &flag);
    if (flag && strcmp(value, "true") == 0)
        return;
    struct win_server *s = w->server = get_memory(sizeof *s);
    s->win = w, s->holders = s->waits = 0;
    s->waiting = get_memory((size_t)w->comm->local->size * sizeof *s->waiting);
    hrecvx(ASK, s->message, MOST_BYTES, -1, w->comm->context, serve, (long)s);
}

/* The handler frees the server: nobody else asks any more. */
void passive_end(struct win *w)
{
    if (w->server)
        win_tell(w, win_node(w, w->comm->local->rank), ASK,
                 (struct win_head){.what = END, .call = CALL_Win_free});
}

/* --- the others --- */

static void ask(struct win *w, int call, int rank, int what, int kind)
{
    const struct nxm_envelope e = {call, ANSWER, win_node(w, rank), w->comm->context};
    struct nxm_status status;
    win_tell(w, e.node, ASK, (struct win_head){.what = what, .call = call, .kind = kind});
    tasks_receive(&e, NULL, 0, &status);
}

static void lock(struct win *w, int call, int rank, int kind, int assert)
{
    bool asks = !(assert &MPI_MODE_NOCHECK);
    if (asks)
        ask(w, call, rank, LOCK, kind);
    w->locked[rank] = asks ? kind : -1;
    w->locks++;
}

/* All accesses to the rank have been carried out when it has answered. */
static void flush(struct win *w, int call, int rank)
{
    access_wait(w, call, rank);
    ask(w, call, rank, FLUSH, 0);
}

static void unlock(struct win *w, int call, int rank)
{
    access_wait(w, call, rank);
    ask(w, call, rank, w->locked[rank] < 0 ? FLUSH : UNLOCK, 0);
    w->locked[rank] = 0;
    w->locks--;
}

bool passive_may(const struct win *w, int rank)
{
    return w->all || w->locked[rank];
}

void passive_send(struct win *w, const struct access *a)
{
    if (!w->locked[a->rank])
        lock(w, a->call, a->rank, MPI_LOCK_SHARED, 0);
    access_send(w, a, ASK, MOST_BYTES - sizeof(struct win_head));
}

/* --- the calls --- */

static int check_rank(struct win *w, int call, int rank)
{
    if (rank >= 0 && rank < w->comm->local->size)
        return MPI_SUCCESS;
    return fail_win(w, call, MPI_ERR_RANK, "there is no rank %d in the window (ranks are 0 to %d)", rank,
                    w->comm->local->size - 1);
}

CALL(Win_lock, (int kind, int rank, int assert, MPI_Win win))
{
    struct win *w = win_of(win);
    if (!w)
        return fail_no_win(CALL_Win_lock);
    if (rank == MPI_PROC_NULL)
        return MPI_SUCCESS;
    if (kind != MPI_LOCK_SHARED && kind != MPI_LOCK_EXCLUSIVE)
        return fail_win(w, CALL_Win_lock, MPI_ERR_LOCKTYPE, "there is no kind of lock %d", kind);
    int code = check_rank(w, CALL_Win_lock, rank);
    if (code)
        return code;
    if (w->all || w->locked[rank] || !w->server)
        return fail_win(w, CALL_Win_lock, MPI_ERR_RMA_SYNC, "%s",
                        w->server ? "the rank is locked already" : "the window's hint no_locks is true");
    lock(w, CALL_Win_lock, rank, kind, assert);
    return MPI_SUCCESS;
}

/* A rank that is locked: alone, or with all. */
static int check_locked(struct win *w, int call, int rank)
{
    if (!w)
        return fail_no_win(call);
    int code = check_rank(w, call, rank);
    if (!code && !passive_may(w, rank))
        code = fail_win(w, call, MPI_ERR_RMA_SYNC, "rank %d is not locked", rank);
    return code;
}

CALL(Win_unlock, (int rank, MPI_Win win))
{
    struct win *w = win_of(win);
    if (rank == MPI_PROC_NULL)
        return MPI_SUCCESS;
    int code = check_locked(w, CALL_Win_unlock, rank);
    if (!code)
        unlock(w, CALL_Win_unlock, rank);
    return code;
}

CALL(Win_lock_all, (int assert, MPI_Win win))
{
    struct win *w = win_of(win);
    (void)assert;
    if (!w)
        return fail_no_win(CALL_Win_lock_all);
    if (w->all || !w->server)
        return fail_win(w, CALL_Win_lock_all, MPI_ERR_RMA_SYNC, "%s",
                        w->server ? "all ranks are locked already" : "the window's hint no_locks is true");
    w->all = true;
    return MPI_SUCCESS;
}

typedef void on_rank(struct win *w, int call, int rank);

static int on_all(struct win *w, int call, on_rank *f)
{
    if (!w)
        return fail_no_win(call);
    for (int i = 0; i < w->comm->local->size; i++)
        if (w->locked[i])
            f(w, call, i);
    return MPI_SUCCESS;
}

CALL(Win_unlock_all, (MPI_Win win))
{
    struct win *w = win_of(win);
    if (w && !w->all)
        return fail_win(w, CALL_Win_unlock_all, MPI_ERR_RMA_SYNC,
                        "the ranks are not locked by MPI_Win_lock_all");
    int code = on_all(w, CALL_Win_unlock_all, unlock);
    if (!code)
        w->all = false;
    return code;
}

CALL(Win_flush, (int rank, MPI_Win win))
{
    struct win *w = win_of(win);
    int code = check_locked(w, CALL_Win_flush, rank);
    if (!code && w->locked[rank])
        flush(w, CALL_Win_flush, rank);
    return code;
}

CALL(Win_flush_all, (MPI_Win win))
{
    return on_all(win_of(win), CALL_Win_flush_all, flush);
}

CALL(Win_flush_local, (int rank, MPI_Win win))
{
    struct win *w = win_of(win);
    int code = check_locked(w, CALL_Win_flush_local, rank);
    if (!code)
        access_wait(w, CALL_Win_flush_local, rank);
    return code;
}

CALL(Win_flush_local_all, (MPI_Win win))
{
    return on_all(win_of(win), CALL_Win_flush_local_all, access_wait);
}

CALL(Win_sync, (MPI_Win win))
{
    return win_of(win) ? MPI_SUCCESS : fail_no_win(CALL_Win_sync);
}
