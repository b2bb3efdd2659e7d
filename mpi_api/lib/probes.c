/* probes.c - looking for messages, and claiming them. */
#include <stdlib.h>
#include "tasks.h"

/* A message that has been claimed: a receive that has it, and has no buffer yet. */
struct claim {
    struct object object;
    int id;
    struct comm *comm;
};

static int look(int call, bool waits, int source, int tag, MPI_Comm comm, struct nxm_status *s, int *flag,
                struct transfer *t)
{
    *t = (struct transfer){call, NULL, 0, MPI_BYTE, source, tag, comm, STANDARD, NULL};
    int code = transfer_check(t, false);
    if (code)
        return code;
    if (source == MPI_PROC_NULL)
        return *flag = true, MPI_SUCCESS;
    struct nxm_envelope e = {call, tag == MPI_ANY_TAG ? -1 : tag,
                             source < 0 ? -1 : group_node(t->c->peers, source), t->c->context};
    do {
        if (tasks_under_way)
            tasks_go_on(call);
        *flag = (int)nxm_probe(&e, waits && !tasks_under_way, s);
    } while (waits && !*flag);
    return MPI_SUCCESS;
}

static int probe(int call, bool waits, int source, int tag, MPI_Comm comm, int *flag, MPI_Status *status)
{
    struct nxm_status s;
    struct transfer t;
    int code = look(call, waits, source, tag, comm, &s, flag, &t);
    if (code || !*flag)
        return code;
    if (source != MPI_PROC_NULL)
        status_of(t.c, &s, status);
    else if (status)
        status_set(status, MPI_PROC_NULL, MPI_ANY_TAG, 0);
    return MPI_SUCCESS;
}

CALL(Probe, (int source, int tag, MPI_Comm comm, MPI_Status *status))
{
    int flag;
    return probe(CALL_Probe, true, source, tag, comm, &flag, status);
}

CALL(Iprobe, (int source, int tag, MPI_Comm comm, int *flag, MPI_Status *status))
{
    return probe(CALL_Iprobe, false, source, tag, comm, flag, status);
}

/* The message that a receive would take is taken by a receive of just its source and tag. */
static int claim(int call, bool waits, int source, int tag, MPI_Comm comm, int *flag, MPI_Message *message,
                 MPI_Status *status)
{
    struct nxm_status s;
    struct transfer t;
    int code = look(call, waits, source, tag, comm, &s, flag, &t);
    if (code || !*flag)
        return code;
    if (source == MPI_PROC_NULL) {
        *message = MPI_MESSAGE_NO_PROC;
        if (status)
            status_set(status, MPI_PROC_NULL, MPI_ANY_TAG, 0);
        return MPI_SUCCESS;
    }
    struct claim *m = object_new(MESSAGE, sizeof *m);
    m->comm = t.c;
    t.c->object.users++;
    m->id = (int)nxm_irecv(&(struct nxm_envelope){call, s.tag, s.node, t.c->context}, NULL, 0);
    *message = HANDLE(MPI_Message, m);
    status_of(t.c, &s, status);
    return MPI_SUCCESS;
}

CALL(Mprobe, (int source, int tag, MPI_Comm comm, MPI_Message *message, MPI_Status *status))
{
    int flag;
    return claim(CALL_Mprobe, true, source, tag, comm, &flag, message, status);
}

CALL(Improbe, (int source, int tag, MPI_Comm comm, int *flag, MPI_Message *message, MPI_Status *status))
{
    return claim(CALL_Improbe, false, source, tag, comm, flag, message, status);
}

static int receive(int call, void *buf, int count, MPI_Datatype type, MPI_Message *message,
                   MPI_Request *request)
{
    struct claim *m = object_of(*message, MESSAGE);
    bool nobody = *message == MPI_MESSAGE_NO_PROC;
    if (!m && !nobody)
        return fail(NULL, call, MPI_ERR_REQUEST, "the message is null, or has been received");
    struct transfer t = {call, buf, count, type, MPI_PROC_NULL, 0, MPI_COMM_NULL, STANDARD, NULL};
    t.c = nobody ? &comm_world : m->comm;
    if (count < 0)
        return fail(t.c, call, MPI_ERR_COUNT, "the count %d is negative", count);
    if (!type_is_valid(type))
        return fail(t.c, call, MPI_ERR_TYPE, "the datatype is null, freed, or not committed");
    struct request *r = transfer_begin(&t, false);
    r->active = true;
    status_set(&r->status, MPI_PROC_NULL, MPI_ANY_TAG, 0);
    if (m) {
        void *at = type_together(buf, count, type, &r->room);
        if (!at)
            at = r->packed = get_memory(r->room);
        nxm_receive_into(m->id, at, (long)r->room);
        r->id = m->id;
        comm_leave(m->comm);
        if (object_leave(&m->object))
            free(m);
    }
    *message = MPI_MESSAGE_NULL;
    *request = HANDLE(MPI_Request, r);
    return MPI_SUCCESS;
}

CALL(Imrecv, (void *buf, int count, MPI_Datatype type, MPI_Message *message, MPI_Request *request))
{
    return receive(CALL_Imrecv, buf, count, type, message, request);
}

CALL(Mrecv, (void *buf, int count, MPI_Datatype type, MPI_Message *message, MPI_Status *status))
{
    MPI_Request request;
    struct nxm_status s = {0};
    int code = receive(CALL_Mrecv, buf, count, type, message, &request);
    if (code)
        return code;
    struct request *r = object_of(request, REQUEST);
    if (r->id)
        tasks_complete(&(struct nxm_completion){CALL_Mrecv, NXM_WAIT, 1, &r->id, &s});
    return request_finish(r, CALL_Mrecv, &s, status);
}
