/* requests.c - waiting for requests, testing and freeing them. */
#include <stdlib.h>
#include "tasks.h"

/* --- the beginning and the end of one --- */

/* Requests that have ended lie here for the next ones, linked by `extra`. They keep their places in the table
 * of objects, of no kind, so that their handles are none. */
READ_OFTEN static struct request *spare;

RUN_OFTEN struct request *request_new(void)
{
    struct request *r = spare;
    if (!r)
        return object_new(REQUEST, sizeof *r);
    spare = r->extra;
    *r = (struct request){.object = {REQUEST, 1, r->object.handle}};
    return r;
}

/* Sends that programs free while they are under way, linked by `extra`. */
static struct request *orphans;

RUN_OFTEN void request_drop(struct request *r)
{
    if (--r->object.users > 0)
        return;
    if (r->comm)
        comm_leave(r->comm);
    type_leave(r->type);
    give_memory(r->prepared);
    give_memory(r->packed);
    r->object.kind = NO_KIND;
    r->extra = spare;
    spare = r;
}

static int end_move(const struct request *r, MPI_Status *status)
{
    if (status)
        status_set(status, MPI_ANY_SOURCE, MPI_ANY_TAG, status_bytes(&r->status));
    return r->status.MPI_ERROR;
}

/* The end of a request that is no message. */
static RUN_SELDOM int end_other(struct request *r, MPI_Status *status)
{
    if (r->what == MOVES)
        return end_move(r, status);
    status_empty(status);
    if (r->what == COLLECTS)
        return task_end(r->task);
    int code = r->query ? r->query(r->extra, status ? status : &r->status) : MPI_SUCCESS;
    int freed = r->release ? r->release(r->extra) : MPI_SUCCESS;
    return code ? code : freed;
}

/* The end of a request that receives nothing, or has received before: by MPI_Request_get_status. */
static inline int end(struct request *r, MPI_Status *status)
{
    if (SELDOM(r->what >= GENERAL))
        return end_other(r, status);
    if (status) {
        int error = status->MPI_ERROR;
        *status = r->status;
        status->MPI_ERROR = error;
    }
    return MPI_SUCCESS;
}

/* The message is in the buffer, or in `packed`. */
static inline int received(struct request *r, int call, const struct nxm_status *s, MPI_Status *status)
{
    if (SELDOM(r->packed) && !s->truncated)
        type_unpack(r->packed, (size_t)s->bytes, r->buf, r->count, r->type);
    status_of(r->comm, s, status);
    return SELDOM(s->truncated) ? message_too_long(r->comm, call, s, r->room) : MPI_SUCCESS;
}

RUN_OFTEN int request_finish(struct request *r, int call, const struct nxm_status *s, MPI_Status *status)
{
    int code;
    if (r->id && r->what == RECEIVES)
        code = received(r, call, s, status);
    else
        code = end(r, status);
    r->id = 0;
    r->active = false;
    give_memory(r->packed);
    r->packed = NULL;
    if (!r->persistent)
        request_drop(r);
    return code;
}

/* --- many --- */

/* The requests of a call, their ids, and what the core says. Those of a call lie here until it is done. */
struct many {
    int call, count;
    struct request **request; /* NULL: of no request */
    int *ids;
    struct nxm_status *status;
    int active, done;                           /* done: those that need not be waited for */
    int messages, collectives, files, generals; /* of the active ones that are not done */
};

READ_OFTEN static void *scratch;
READ_OFTEN static size_t scratch_bytes;

static inline bool is_done(struct request *r)
{
    if (USUALLY(r->id)) /* a message under way */
        return false;
    if (r->what == COLLECTS)
        return task_is_done(r->task);
    if (r->what == MOVES && r->end)
        r->end(r, false);
    if (r->what == MOVES)
        return !r->end;
    return r->what != GENERAL || r->count;
}

RUN_OFTEN static int gather(struct many *m, int call, int count, const MPI_Request requests[])
{
    size_t each = sizeof *m->request + sizeof *m->ids + sizeof *m->status;
    size_t bytes = (size_t)count * each;
    if (tasks_under_way)
        tasks_go_on(call);
    if (bytes > scratch_bytes) {
        free(scratch);
        scratch = get_memory(bytes);
        scratch_bytes = bytes;
    }
    *m = (struct many){.call = call, .count = count, .request = scratch};
    m->status = (struct nxm_status *)(m->request + count);
    m->ids = (int *)(m->status + count);
    for (int i = 0; i < count; i++) {
        struct request *r = object_of(requests[i], REQUEST);
        if (!r && requests[i] != MPI_REQUEST_NULL)
            return fail(NULL, call, MPI_ERR_REQUEST, "request %d is none, or has been freed", i);
        m->request[i] = r && r->active ? r : NULL;
        m->ids[i] = m->request[i] ? r->id : 0;
        m->status[i] = (struct nxm_status){0};
        if (!m->request[i])
            continue;
        if (r->what == MOVES)
            r->envelope.call = call;
        bool done = is_done(r);
        m->active++;
        m->done += done;
        m->messages += m->ids[i] != 0;
        m->collectives += r->what == COLLECTS && !done;
        m->files += r->what == MOVES && !done;
        m->generals += r->what == GENERAL && !done;
    }
    return MPI_SUCCESS;
}

/* Looks at, or waits for, those that send or receive. */
static inline bool complete(const struct many *m, int how)
{
    return m->messages && tasks_complete(&(struct nxm_completion){m->call, how, m->count, m->ids, m->status});
}

static bool any_collective_done(const struct many *m)
{
    for (int i = 0; i < m->count; i++)
        if (m->request[i] && m->request[i]->what == COLLECTS && is_done(m->request[i]))
            return true;
    return false;
}

/* Waits for movements of files: all, or the first. They end whatever other ranks do. */
static void wait_for_files(const struct many *m, bool all)
{
    int left = all ? m->files : 1;
    for (int i = 0; left > 0; i++)
        if (m->request[i] && m->request[i]->what == MOVES && m->request[i]->end) {
            m->request[i]->end(m->request[i], true);
            left--;
        }
}

/* Waits until one is done, or more. */
static void wait_for_one(const struct many *m, int how)
{
    if (m->files) {
        wait_for_files(m, false);
        return;
    }
    if (!m->collectives) {
        complete(m, how | NXM_WAIT);
        return;
    }
    while (!complete(m, how) && !any_collective_done(m)) {
        tasks_wait_for_any(m->call, m->count, m->ids, m->status);
        tasks_go_on(m->call);
    }
}

static inline void wait_for_all(const struct many *m)
{
    for (int i = 0; i < m->count; i++)
        if (m->request[i] && m->request[i]->what == COLLECTS)
            tasks_wait(m->call, m->request[i]->task);
    complete(m, NXM_WAIT);
    if (m->files)
        wait_for_files(m, true);
}

/* Request i is done. */
RUN_OFTEN static int finish(const struct many *m, int i, MPI_Request requests[], MPI_Status *status)
{
    struct request *r = m->request[i];
    bool stays = r->persistent;
    int code = request_finish(r, m->call, &m->status[i], status);
    if (!stays)
        requests[i] = MPI_REQUEST_NULL;
    return code;
}

static bool ended(const struct many *m, int i)
{
    return m->request[i] && (m->status[i].done || is_done(m->request[i]));
}

RUN_OFTEN static int finish_all(const struct many *m, MPI_Request requests[], MPI_Status statuses[])
{
    int code = MPI_SUCCESS;
    for (int i = 0; i < m->count; i++) {
        MPI_Status *status = statuses ? &statuses[i] : NULL;
        int one = MPI_SUCCESS;
        if (m->request[i])
            one = finish(m, i, requests, status);
        else
            status_empty(status);
        if (one && !code && statuses)
            for (int k = 0; k < i; k++)
                statuses[k].MPI_ERROR = MPI_SUCCESS;
        code = one ? one : code;
        if (code && status)
            status->MPI_ERROR = one;
    }
    return code ? MPI_ERR_IN_STATUS : MPI_SUCCESS;
}

/* --- the calls --- */

static int no_end(int call)
{
    return fail(NULL, call, MPI_ERR_REQUEST,
                "a generalized request is waited for that nobody else can complete: a rank has one thread");
}

static void wait_for_file(int call, struct request *r)
{
    r->envelope.call = call;
    if (r->end)
        r->end(r, true);
}

OFTEN_CALL(Wait, (MPI_Request * request, MPI_Status *status))
{
    struct request *r = object_of(*request, REQUEST);
    struct nxm_status s = {0};
    if (!r && *request != MPI_REQUEST_NULL)
        return fail(NULL, CALL_Wait, MPI_ERR_REQUEST, "the request is none, or has been freed");
    if (!r || !r->active) {
        status_empty(status);
        return MPI_SUCCESS;
    }
    if (r->id)
        tasks_complete(&(struct nxm_completion){CALL_Wait, NXM_WAIT, 1, &r->id, &s});
    else if (r->what == COLLECTS)
        tasks_wait(CALL_Wait, r->task);
    else if (r->what == MOVES)
        wait_for_file(CALL_Wait, r);
    else if (!is_done(r))
        return no_end(CALL_Wait);
    if (!r->persistent)
        *request = MPI_REQUEST_NULL;
    return request_finish(r, CALL_Wait, &s, status);
}

OFTEN_CALL(Waitall, (int count, MPI_Request requests[], MPI_Status statuses[]))
{
    struct many m;
    int code = gather(&m, CALL_Waitall, count, requests);
    if (code)
        return code;
    if (m.generals)
        return no_end(CALL_Waitall);
    if (m.active > m.done)
        wait_for_all(&m);
    return finish_all(&m, requests, statuses);
}

/* The message that the core has just handed over must be told of now, before collectives that are done. */
static int first_ended(const struct many *m)
{
    int i = 0;
    while (i < m->count && !m->status[i].done)
        i++;
    if (i < m->count)
        return i;
    for (i = 0; i < m->count && !ended(m, i); i++)
        continue;
    return i;
}

static int wait_any(int call, bool waits, int count, MPI_Request requests[], int *index, int *flag,
                    MPI_Status *status)
{
    struct many m;
    int code = gather(&m, call, count, requests);
    if (code)
        return *index = MPI_UNDEFINED, code;
    *flag = true, *index = MPI_UNDEFINED;
    if (!m.active) {
        status_empty(status);
        return MPI_SUCCESS;
    }
    if (waits && m.generals == m.active)
        return no_end(call);
    if (!m.done && waits)
        wait_for_one(&m, NXM_ANY);
    else if (!m.done)
        complete(&m, NXM_ANY);
    int i = first_ended(&m);
    if (i == m.count)
        return *flag = false, MPI_SUCCESS;
    *index = i;
    return finish(&m, i, requests, status);
}

CALL(Waitany, (int count, MPI_Request requests[], int *index, MPI_Status *status))
{
    int flag;
    return wait_any(CALL_Waitany, true, count, requests, index, &flag, status);
}

CALL(Testany, (int count, MPI_Request requests[], int *index, int *flag, MPI_Status *status))
{
    return wait_any(CALL_Testany, false, count, requests, index, flag, status);
}

static int wait_some(int call, bool waits, int count, MPI_Request requests[], int *done, int indices[],
                     MPI_Status statuses[])
{
    struct many m;
    int code = gather(&m, call, count, requests), n = 0;
    *done = m.active && !code ? 0 : MPI_UNDEFINED;
    if (code || !m.active)
        return code;
    if (waits && m.generals == m.active)
        return no_end(call);
    if (!m.done && waits)
        wait_for_one(&m, NXM_SOME);
    else if (m.active > m.done)
        complete(&m, NXM_SOME);
    for (int i = 0; i < count; i++)
        if (ended(&m, i)) {
            MPI_Status *status = statuses ? &statuses[n] : NULL;
            int one = finish(&m, i, requests, status);
            indices[n++] = i;
            if (status)
                status->MPI_ERROR = one;
            code = one ? MPI_ERR_IN_STATUS : code;
        }
    *done = n;
    return code;
}

CALL(Waitsome, (int count, MPI_Request requests[], int *done, int indices[], MPI_Status statuses[]))
{
    return wait_some(CALL_Waitsome, true, count, requests, done, indices, statuses);
}

CALL(Testsome, (int count, MPI_Request requests[], int *done, int indices[], MPI_Status statuses[]))
{
    return wait_some(CALL_Testsome, false, count, requests, done, indices, statuses);
}

CALL(Test, (MPI_Request * request, int *flag, MPI_Status *status))
{
    int index;
    return wait_any(CALL_Test, false, 1, request, &index, flag, status);
}

CALL(Testall, (int count, MPI_Request requests[], int *flag, MPI_Status statuses[]))
{
    struct many m;
    int code = gather(&m, CALL_Testall, count, requests);
    if (code)
        return code;
    *flag = !m.generals && !m.collectives && !m.files && (!m.messages || complete(&m, NXM_ALL));
    return *flag ? finish_all(&m, requests, statuses) : MPI_SUCCESS;
}

/* --- starting again, and ending --- */

static int start(int call, MPI_Request request)
{
    struct request *r = object_of(request, REQUEST);
    if (!r || !r->persistent || r->active)
        return fail(NULL, call, MPI_ERR_REQUEST, "%s",
                    r && r->persistent ? "the request is under way already"
                                       : "the request is no persistent one");
    r->envelope.call = call;
    if (r->what == COLLECTS)
        coll_restart(r);
    else
        request_start(r);
    r->active = !r->status.MPI_ERROR;
    return r->status.MPI_ERROR;
}

CALL(Start, (MPI_Request * request))
{
    return start(CALL_Start, *request);
}

CALL(Startall, (int count, MPI_Request requests[]))
{
    int code = MPI_SUCCESS;
    for (int i = 0; i < count && !code; i++)
        code = start(CALL_Startall, requests[i]);
    return code;
}

/* Ends the freed sends that are done. */
static void settle_orphans(void)
{
    for (struct request **link = &orphans, *r; (r = *link);) {
        struct nxm_status s;
        if (nxm_complete(&(struct nxm_completion){CALL_Request_free, NXM_ALL, 1, &r->id, &s})) {
            *link = r->extra;
            request_drop(r);
        } else {
            link = (struct request **)&r->extra;
        }
    }
}

/* A freed receive, as a task: its message comes into the buffer all the same. */
static int receive_rest(struct args *a)
{
    struct request *r = a->into;
    struct nxm_status s = {0};
    tasks_complete(&(struct nxm_completion){CALL_Request_free, NXM_WAIT, 1, &r->id, &s});
    return request_finish(r, CALL_Request_free, &s, NULL);
}

/* The request goes on without its handle. */
static void orphan(struct request *r)
{
    r->object.kind = NO_KIND;
    r->persistent = false;
    if (r->what == RECEIVES) {
        task_detach(task_start(receive_rest, &(struct args){.into = r}));
    } else {
        r->extra = orphans;
        orphans = r;
    }
}

/* One that is not complete stays, inactive, until it is. */
static int free_general(struct request *r)
{
    r->active = false;
    if (!r->count)
        return MPI_SUCCESS;
    int code = r->release ? r->release(r->extra) : MPI_SUCCESS;
    request_drop(r);
    return code;
}

CALL(Request_free, (MPI_Request * request))
{
    struct request *r = object_of(*request, REQUEST);
    if (!r)
        return fail(NULL, CALL_Request_free, MPI_ERR_REQUEST, "the request is null, or has been freed");
    settle_orphans();
    *request = MPI_REQUEST_NULL;
    if (r->active && r->id)
        return orphan(r), MPI_SUCCESS;
    if (r->what == MOVES)
        wait_for_file(CALL_Request_free, r);
    if (r->what == GENERAL)
        return free_general(r);
    if (r->prepared)
        coll_forget(r->prepared);
    request_drop(r);
    return MPI_SUCCESS;
}

CALL(Request_get_status, (MPI_Request request, int *flag, MPI_Status *status))
{
    struct request *r = object_of(request, REQUEST);
    struct nxm_status s;
    if (!r && request != MPI_REQUEST_NULL)
        return fail(NULL, CALL_Request_get_status, MPI_ERR_REQUEST, "the request is none, or has been freed");
    *flag = true;
    if (!r || !r->active) {
        status_empty(status);
        return MPI_SUCCESS;
    }
    if (r->what == COLLECTS)
        return tasks_go_on(CALL_Request_get_status), *flag = is_done(r), status_empty(status), MPI_SUCCESS;
    if (r->what == MOVES)
        r->envelope.call = CALL_Request_get_status, *flag = is_done(r);
    if (!*flag)
        return MPI_SUCCESS;
    if (r->what == GENERAL)
        return *flag = is_done(r), *flag && status && r->query ? r->query(r->extra, status) : MPI_SUCCESS;
    if (r->id && !nxm_complete(&(struct nxm_completion){CALL_Request_get_status, NXM_ALL, 1, &r->id, &s}))
        return *flag = false, MPI_SUCCESS;
    if (r->id && r->what == RECEIVES) {
        received(r, CALL_Request_get_status, &s, &r->status);
        free(r->packed);
        r->packed = NULL;
    }
    r->id = 0; /* it stays, done, until it is waited for */
    if (status)
        *status = r->status;
    return MPI_SUCCESS;
}

/* A receive that has no message yet; sends go on, as the standard allows. */
CALL(Cancel, (MPI_Request * request))
{
    struct request *r = object_of(*request, REQUEST);
    if (!r)
        return fail(NULL, CALL_Cancel, MPI_ERR_REQUEST, "the request is null, or has been freed");
    if (r->what == GENERAL)
        return r->cancel ? r->cancel(r->extra, r->count) : MPI_SUCCESS;
    if (r->what == RECEIVES && r->id && nxm_cancel(CALL_Cancel, r->id)) {
        r->id = 0;
        r->status.MPI_internal[2] = true;
    }
    return MPI_SUCCESS;
}

/* --- generalized --- */

CALL(Grequest_start, (MPI_Grequest_query_function * query, MPI_Grequest_free_function *release,
                      MPI_Grequest_cancel_function *cancel, void *extra, MPI_Request *request))
{
    struct request *r = request_new();
    r->what = GENERAL, r->active = true;
    r->query = query, r->release = release, r->cancel = cancel, r->extra = extra;
    *request = HANDLE(MPI_Request, r);
    return MPI_SUCCESS;
}

CALL(Grequest_complete, (MPI_Request request))
{
    struct request *r = object_of(request, REQUEST);
    if (!r || r->what != GENERAL)
        return fail(NULL, CALL_Grequest_complete, MPI_ERR_REQUEST, "no generalized request");
    r->count = 1;
    return r->active ? MPI_SUCCESS : free_general(r);
}
