/* coll.c - see coll.h. */
#include "coll.h"
#include <stdlib.h>

int coll_begin(struct coll *o, int call, MPI_Comm comm)
{
    *o = (struct coll){comm_of(comm), call};
    if (!o->c)
        return fail_comm(call);
    if (o->c->remote)
        return fail(o->c, call, MPI_ERR_COMM, "collectives of communicators of two groups are not there");
    return MPI_SUCCESS;
}

int coll_check_root(const struct coll *o, int root)
{
    if (root >= 0 && root < coll_size(o))
        return MPI_SUCCESS;
    return fail(o->c, o->call, MPI_ERR_ROOT, "root %d is not one of the communicator's ranks (0 to %d)", root,
                coll_size(o) - 1);
}

int coll_check(const struct coll *o, int count, MPI_Datatype t)
{
    if (count < 0)
        return fail(o->c, o->call, MPI_ERR_COUNT, "the count %d is negative", count);
    if (!type_is_valid(t))
        return fail(o->c, o->call, MPI_ERR_TYPE, "the datatype is null, freed, or not committed");
    return MPI_SUCCESS;
}

/* --- messages --- */

static struct nxm_envelope envelope(const struct coll *o, int peer)
{
    return (struct nxm_envelope){o->call, o->call, group_node(o->c->local, peer), o->c->context + 1};
}

void coll_send(const struct coll *o, const void *buf, int count, MPI_Datatype t, int to)
{
    size_t bytes;
    const struct nxm_envelope e = envelope(o, to);
    const void *at = type_together(buf, count, t, &bytes);
    char *packed = at || !bytes ? NULL : get_memory(bytes);
    if (packed)
        type_pack(buf, count, t, packed);
    nxm_send(&e, at ? at : packed, (long)bytes, false);
    free(packed);
}

static int too_long(const struct coll *o, const struct nxm_status *s, size_t room)
{
    return fail(o->c, o->call, MPI_ERR_TRUNCATE,
                "rank %d sends %ld bytes, but this one expects %zu: counts or datatypes differ",
                group_rank_of(o->c->local, s->node), s->bytes, room);
}

int coll_receive(const struct coll *o, void *buf, int count, MPI_Datatype t, int from)
{
    size_t room;
    struct nxm_status s;
    const struct nxm_envelope e = envelope(o, from);
    void *at = type_together(buf, count, t, &room);
    char *packed = at || !room ? NULL : get_memory(room);
    nxm_recv(&e, at ? at : packed, (long)room, &s);
    if (packed && !s.truncated)
        type_unpack(packed, (size_t)s.bytes, buf, count, t);
    free(packed);
    return s.truncated ? too_long(o, &s, room) : MPI_SUCCESS;
}

struct request *coll_start(const struct coll *o, bool sends, void *buf, int count, MPI_Datatype t, int peer)
{
    struct request *r = object_new(REQUEST, sizeof *r);
    r->what = sends ? SENDS : RECEIVES, r->mode = READY;
    r->comm = o->c, r->peer = peer;
    r->buf = buf, r->count = count, r->type = t;
    r->envelope = envelope(o, peer);
    request_start(r);
    return r;
}

int coll_wait(const struct coll *o, int count, struct request *r[])
{
    int *ids = get_memory((size_t)count * sizeof *ids), code = MPI_SUCCESS;
    struct nxm_status *status = get_memory((size_t)count * sizeof *status);
    bool any = false;
    for (int i = 0; i < count; i++) {
        ids[i] = r[i] ? r[i]->id : 0;
        any = any || ids[i];
    }
    if (any)
        nxm_complete(&(struct nxm_completion){o->call, NXM_WAIT, count, ids, status});
    for (int i = 0; i < count; i++) {
        int one = r[i] ? request_finish(r[i], o->call, &status[i], NULL) : MPI_SUCCESS;
        code = one ? one : code;
    }
    free(ids);
    free(status);
    return code;
}

int coll_exchange(const struct coll *o, const void *buf, int count, MPI_Datatype t, int to, void *into,
                  int room, MPI_Datatype as, int from)
{
    struct request *r[2] = {coll_start(o, false, into, room, as, from),
                            coll_start(o, true, (void *)(uintptr_t)buf, count, t, to)};
    return coll_wait(o, 2, r);
}
