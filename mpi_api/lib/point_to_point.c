/* point_to_point.c - point to point: checks, and blocking sends and receives. */
#include <stdlib.h>
#include "tasks.h"

/* --- statuses --- */

size_t status_bytes(const MPI_Status *status)
{
    return (size_t)(unsigned)status->MPI_internal[0] | (size_t)status->MPI_internal[1] << 32;
}

void status_empty(MPI_Status *status)
{
    if (!status)
        return;
    status_set(status, MPI_ANY_SOURCE, MPI_ANY_TAG, 0);
    status->MPI_ERROR = MPI_SUCCESS;
}

static void status_of_nobody(MPI_Status *status)
{
    if (status)
        status_set(status, MPI_PROC_NULL, MPI_ANY_TAG, 0);
}

/* --- checks --- */

static inline bool peer_is_right(const struct transfer *t, bool sends)
{
    return (unsigned)t->peer < (unsigned)t->c->peers->size || t->peer == MPI_PROC_NULL ||
           (!sends && t->peer == MPI_ANY_SOURCE);
}

static inline bool tag_is_right(const struct transfer *t, bool sends)
{
    return (unsigned)t->tag <= 999999999 || (!sends && t->tag == MPI_ANY_TAG);
}

/* A null pointer is a buffer where nothing is sent or received. */
static bool null_is_right(const struct transfer *t)
{
    return !t->count || !type_basic(t->type) || !size_of(t->type) || t->peer == MPI_PROC_NULL;
}

static int wrong_peer(const struct transfer *t, bool sends)
{
    int last = t->c->peers->size - 1;
    if (t->peer == MPI_ANY_SOURCE && sends)
        return fail(t->c, t->call, MPI_ERR_RANK, "a message is sent to one rank, not to MPI_ANY_SOURCE");
    return fail(t->c, t->call, MPI_ERR_RANK, "there is no rank %d in the communicator (ranks are 0 to %d)",
                t->peer, last);
}

static int wrong_tag(const struct transfer *t)
{
    return fail(t->c, t->call, MPI_ERR_TAG, "tag %d is out of range (0 to 999999999)", t->tag);
}

/* Tells what is wrong. */
static RUN_SELDOM int wrong(const struct transfer *t, bool sends)
{
    if (!t->c)
        return fail_comm(t->call);
    if (!peer_is_right(t, sends))
        return wrong_peer(t, sends);
    if (!tag_is_right(t, sends))
        return wrong_tag(t);
    if (t->count < 0)
        return fail(t->c, t->call, MPI_ERR_COUNT, "the count %d is negative", t->count);
    if (!type_is_valid(t->type))
        return fail(t->c, t->call, MPI_ERR_TYPE, "the datatype is null, freed, or not committed");
    return fail(t->c, t->call, MPI_ERR_BUFFER, "the buffer is a null pointer, and the count is %d", t->count);
}

static inline __attribute__((always_inline)) int check(struct transfer *t, bool sends)
{
    t->c = comm_of(t->comm);
    if (USUALLY(t->c) && USUALLY(peer_is_right(t, sends)) && USUALLY(tag_is_right(t, sends)) &&
        USUALLY(t->count >= 0) && USUALLY(type_is_valid(t->type)) && (USUALLY(t->buf) || null_is_right(t)))
        return MPI_SUCCESS;
    return wrong(t, sends);
}

int transfer_check(struct transfer *t, bool sends)
{
    return check(t, sends);
}

static inline struct nxm_envelope envelope_of(const struct transfer *t)
{
    return (struct nxm_envelope){t->call, t->tag == MPI_ANY_TAG ? -1 : t->tag,
                                 t->peer < 0 ? -1 : group_node(t->c->peers, t->peer), t->c->context};
}

/* --- blocking --- */

static inline bool is_held(enum mode mode, size_t bytes)
{
    return USUALLY(mode == STANDARD) ? bytes > (size_t)mpi_eager_limit : mode == SYNCHRONOUS;
}

/* While collectives are under way: with an id, so that they go on. (tasks_receive does so, too.) */
static inline void send(const struct nxm_envelope *e, const void *at, size_t bytes, bool held)
{
    if (USUALLY(!tasks_under_way)) {
        nxm_send(e, at, (long)bytes, held);
        return;
    }
    int id = (int)nxm_isend(e, at, (long)bytes, held);
    if (id)
        tasks_complete(&(struct nxm_completion){e->call, NXM_WAIT, 1, &id, &(struct nxm_status){0}});
}

/* Elements that do not lie together, or are none. */
static RUN_SELDOM void send_packed(const struct transfer *t, const struct nxm_envelope *e, size_t bytes)
{
    char *packed = get_memory(bytes);
    type_pack(t->buf, t->count, t->type, packed);
    send(e, packed, bytes, is_held(t->mode, bytes));
    free(packed);
}

static inline __attribute__((always_inline)) int transfer_send(const struct transfer *t)
{
    size_t bytes;
    if (SELDOM(t->peer == MPI_PROC_NULL))
        return MPI_SUCCESS;
    const struct nxm_envelope e = envelope_of(t);
    const void *at = type_together(t->buf, t->count, t->type, &bytes);
    if (USUALLY(at))
        send(&e, at, bytes, is_held(t->mode, bytes));
    else
        send_packed(t, &e, bytes);
    return MPI_SUCCESS;
}

RUN_SELDOM int message_too_long(struct comm *c, int call, const struct nxm_status *s, size_t room)
{
    return fail(c, call, MPI_ERR_TRUNCATE,
                "the message of tag %d from rank %d has %ld bytes, but the buffer only %zu", s->tag,
                group_rank_of(c->peers, s->node), s->bytes, room);
}

static RUN_SELDOM void receive_packed(const struct transfer *t, const struct nxm_envelope *e, size_t room,
                                      struct nxm_status *s)
{
    char *packed = get_memory(room);
    tasks_receive(e, packed, room, s);
    if (!s->truncated && packed)
        type_unpack(packed, (size_t)s->bytes, (void *)(uintptr_t)t->buf, t->count, t->type);
    free(packed);
}

static inline int transfer_receive(const struct transfer *t, MPI_Status *status)
{
    size_t room;
    struct nxm_status s;
    if (SELDOM(t->peer == MPI_PROC_NULL)) {
        status_of_nobody(status);
        return MPI_SUCCESS;
    }
    const struct nxm_envelope e = envelope_of(t);
    void *at = type_together(t->buf, t->count, t->type, &room);
    if (USUALLY(at))
        tasks_receive(&e, at, room, &s);
    else
        receive_packed(t, &e, room, &s);
    status_of(t->c, &s, status);
    return SELDOM(s.truncated) ? message_too_long(t->c, t->call, &s, room) : MPI_SUCCESS;
}

/* --- those with requests --- */

RUN_OFTEN struct request *transfer_begin(const struct transfer *t, bool sends)
{
    struct request *r = request_new();
    r->what = sends ? SENDS : RECEIVES;
    r->comm = t->c;
    t->c->object.users++;
    type_keep(t->type);
    r->peer = t->peer;
    r->mode = t->mode;
    r->buf = (void *)(uintptr_t)t->buf, r->count = t->count, r->type = t->type;
    if (t->peer != MPI_PROC_NULL)
        r->envelope = envelope_of(t);
    r->envelope.call = t->call;
    return r;
}

RUN_OFTEN static inline void start_send(struct request *r)
{
    size_t bytes;
    const void *at = type_together(r->buf, r->count, r->type, &bytes);
    if (SELDOM(!at)) {
        r->packed = get_memory(bytes);
        type_pack(r->buf, r->count, r->type, r->packed);
        at = r->packed;
    }
    r->id = (int)nxm_isend(&r->envelope, at, (long)bytes, is_held(r->mode, bytes));
    if (!r->id) {
        give_memory(r->packed);
        r->packed = NULL;
    }
}

RUN_OFTEN static inline void start_receive(struct request *r)
{
    void *at = type_together(r->buf, r->count, r->type, &r->room);
    if (SELDOM(!at))
        at = r->packed = get_memory(r->room);
    r->id = (int)nxm_irecv(&r->envelope, at, (long)r->room);
}

static RUN_SELDOM void start_buffered(struct request *r)
{
    struct transfer t = {r->envelope.call, r->buf,        r->count, r->type, r->peer,
                         r->envelope.tag,  MPI_COMM_NULL, BUFFERED, r->comm};
    r->status.MPI_ERROR = buffered_send(&t);
}

RUN_OFTEN void request_start(struct request *r)
{
    r->active = true;
    r->id = 0;
    status_empty(&r->status);
    if (SELDOM(r->peer == MPI_PROC_NULL)) {
        if (r->what == RECEIVES)
            status_of_nobody(&r->status);
    } else if (SELDOM(r->mode == BUFFERED) && r->what == SENDS) {
        start_buffered(r);
    } else if (r->what == SENDS) {
        start_send(r);
    } else {
        start_receive(r);
    }
}

RUN_OFTEN static int begin(struct transfer *t, bool sends, MPI_Request *request)
{
    int code = check(t, sends);
    if (SELDOM(code))
        return code;
    struct request *r = transfer_begin(t, sends);
    request_start(r);
    *request = HANDLE(MPI_Request, r);
    return MPI_SUCCESS;
}

/* One that has no room ends here; another is done at once. */
static RUN_SELDOM int begin_buffered(struct transfer *t, MPI_Request *request)
{
    int code = transfer_check(t, true);
    code = code ? code : buffered_send(t);
    if (code)
        return code;
    struct request *r = transfer_begin(t, true);
    r->active = true;
    status_empty(&r->status);
    *request = HANDLE(MPI_Request, r);
    return MPI_SUCCESS;
}

static int prepare(struct transfer *t, bool sends, MPI_Request *request)
{
    int code = transfer_check(t, sends);
    if (code)
        return code;
    t->call = CALL_Start;
    struct request *r = transfer_begin(t, sends);
    r->persistent = true;
    *request = HANDLE(MPI_Request, r);
    return MPI_SUCCESS;
}

/* --- the calls --- */

#define SEND(call, name, iname, mode)                                                                        \
    call(name, (const void *buf, int count, MPI_Datatype type, int dest, int tag, MPI_Comm comm))            \
    {                                                                                                        \
        struct transfer t = {CALL_##name, buf, count, type, dest, tag, comm, mode, NULL};                    \
        int code = check(&t, true);                                                                          \
        if (SELDOM(code))                                                                                    \
            return code;                                                                                     \
        return mode == BUFFERED ? buffered_send(&t) : transfer_send(&t);                                     \
    }                                                                                                        \
    call(iname, (const void *buf, int count, MPI_Datatype type, int dest, int tag, MPI_Comm comm,            \
                 MPI_Request *request))                                                                      \
    {                                                                                                        \
        struct transfer t = {CALL_##iname, buf, count, type, dest, tag, comm, mode, NULL};                   \
        return mode == BUFFERED ? begin_buffered(&t, request) : begin(&t, true, request);                    \
    }                                                                                                        \
    CALL(name##_init, (const void *buf, int count, MPI_Datatype type, int dest, int tag, MPI_Comm comm,      \
                       MPI_Request *request))                                                                \
    {                                                                                                        \
        struct transfer t = {CALL_##name##_init, buf, count, type, dest, tag, comm, mode, NULL};             \
        return prepare(&t, true, request);                                                                   \
    }
SEND(OFTEN_CALL, Send, Isend, STANDARD)
SEND(CALL, Bsend, Ibsend, BUFFERED)
SEND(CALL, Ssend, Issend, SYNCHRONOUS)
SEND(CALL, Rsend, Irsend, READY)

OFTEN_CALL(Recv,
           (void *buf, int count, MPI_Datatype type, int source, int tag, MPI_Comm comm, MPI_Status *status))
{
    struct transfer t = {CALL_Recv, buf, count, type, source, tag, comm, STANDARD, NULL};
    int code = check(&t, false);
    return SELDOM(code) ? code : transfer_receive(&t, status);
}

OFTEN_CALL(Irecv, (void *buf, int count, MPI_Datatype type, int source, int tag, MPI_Comm comm,
                   MPI_Request *request))
{
    struct transfer t = {CALL_Irecv, buf, count, type, source, tag, comm, STANDARD, NULL};
    return begin(&t, false, request);
}

CALL(Recv_init,
     (void *buf, int count, MPI_Datatype type, int source, int tag, MPI_Comm comm, MPI_Request *request))
{
    struct transfer t = {CALL_Recv_init, buf, count, type, source, tag, comm, STANDARD, NULL};
    return prepare(&t, false, request);
}

/* The receive is posted, the message is sent, the receive is waited for. */
static inline __attribute__((always_inline)) int send_and_receive(struct transfer *out, struct transfer *in,
                                                                  MPI_Status *status)
{
    MPI_Request request;
    int code = transfer_check(out, true);
    if (!code)
        code = begin(in, false, &request);
    if (code)
        return code;
    struct request *r = object_of(request, REQUEST), *s = transfer_begin(out, true);
    request_start(s);
    int ids[2] = {s->id, r->id};
    struct nxm_status done[2] = {{0}, {0}};
    if (ids[0] || ids[1])
        tasks_complete(&(struct nxm_completion){out->call, NXM_WAIT, 2, ids, done});
    request_finish(s, out->call, &done[0], NULL);
    return request_finish(r, out->call, &done[1], status);
}

CALL(Sendrecv, (const void *buf, int count, MPI_Datatype type, int dest, int tag, void *into, int room,
                MPI_Datatype as, int source, int select, MPI_Comm comm, MPI_Status *status))
{
    struct transfer out = {CALL_Sendrecv, buf, count, type, dest, tag, comm, STANDARD, NULL};
    struct transfer in = {CALL_Sendrecv, into, room, as, source, select, comm, STANDARD, NULL};
    return send_and_receive(&out, &in, status);
}

CALL(Sendrecv_replace, (void *buf, int count, MPI_Datatype type, int dest, int tag, int source, int select,
                        MPI_Comm comm, MPI_Status *status))
{
    struct transfer out = {CALL_Sendrecv_replace, buf, count, type, dest, tag, comm, STANDARD, NULL};
    struct transfer in = {CALL_Sendrecv_replace, buf, count, type, source, select, comm, STANDARD, NULL};
    int code = transfer_check(&out, true);
    if (code)
        return code;
    size_t bytes = (size_t)count * size_of(type);
    char *copy = get_memory(bytes);
    type_pack(buf, count, type, copy);
    out.buf = copy, out.count = (int)bytes, out.type = MPI_BYTE;
    code = send_and_receive(&out, &in, status);
    free(copy);
    return code;
}

/* The request is the receive's; a copy of the message goes, which its owner may forget. */
static int copy_and_receive(struct transfer *out, struct transfer *in, MPI_Request *request)
{
    int code = transfer_check(out, true);
    if (!code && out->peer != MPI_PROC_NULL)
        buffered_copy(out);
    return code ? code : begin(in, false, request);
}

CALL(Isendrecv, (const void *buf, int count, MPI_Datatype type, int dest, int tag, void *into, int room,
                 MPI_Datatype as, int source, int select, MPI_Comm comm, MPI_Request *request))
{
    struct transfer out = {CALL_Isendrecv, buf, count, type, dest, tag, comm, STANDARD, NULL};
    struct transfer in = {CALL_Isendrecv, into, room, as, source, select, comm, STANDARD, NULL};
    return copy_and_receive(&out, &in, request);
}

CALL(Isendrecv_replace, (void *buf, int count, MPI_Datatype type, int dest, int tag, int source, int select,
                         MPI_Comm comm, MPI_Request *request))
{
    struct transfer out = {CALL_Isendrecv_replace, buf, count, type, dest, tag, comm, STANDARD, NULL};
    struct transfer in = {CALL_Isendrecv_replace, buf, count, type, source, select, comm, STANDARD, NULL};
    return copy_and_receive(&out, &in, request);
}
