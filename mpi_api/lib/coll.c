/* coll.c - see coll.h. */
#include "coll.h"
#include <stdlib.h>
#include "tasks.h"

/* --- beginning --- */

/* Tags below this are those of collectives, the others of Comm_create_group. */
enum { COLLECTIVES = 900000000 };

struct coll coll_of(struct comm *c, int call)
{
    const struct group *g = c->remote ? c->remote : c->local;
    c->collectives = (c->collectives + 1) % COLLECTIVES;
    return (struct coll){c, call, c->collectives, g, g->size, c->local->rank};
}

struct coll coll_inside(const struct coll *o)
{
    struct coll in = *o;
    in.group = o->c->local, in.size = o->c->local->size;
    return in;
}

/* What has failed is none: the program may call it again, with better arguments, beside the others. */
static void take_back(struct comm *c)
{
    c->collectives = (c->collectives + COLLECTIVES - 1) % COLLECTIVES;
}

/* What Start needs of a persistent collective. */
struct prepared {
    struct args args;
    coll_run *run;
};

void args_keep(const struct args *a)
{
    op_keep(a->op);
    type_keep(a->type);
    type_keep(a->as);
}

void args_leave(const struct args *a)
{
    op_leave(a->op);
    type_leave(a->type);
    type_leave(a->as);
}

/* A copy of a list of datatypes; NULL: of none. */
static const MPI_Datatype *types_keep(const MPI_Datatype *types, int count)
{
    MPI_Datatype *copy = types ? get_memory((size_t)count * sizeof *copy) : NULL;
    for (int i = 0; copy && i < count; i++)
        type_keep(copy[i] = types[i]);
    return copy;
}

static void types_leave(const MPI_Datatype *types, int count)
{
    for (int i = 0; types && i < count; i++)
        type_leave(types[i]);
    free((void *)(uintptr_t)types);
}

void coll_forget(const struct prepared *p)
{
    const struct args *a = &p->args;
    args_leave(a);
    types_leave(a->types, a->o.size);
    types_leave(a->ases, a->o.size);
}

void coll_keep_list(MPI_Request request, void *list)
{
    struct request *r = object_of(request, REQUEST);
    r->packed = list; /* freed when it is done */
}

int coll_prepare(struct args *a, int call, MPI_Comm comm, coll_run *check, coll_run *run,
                 MPI_Request *request)
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(call);
    a->o = coll_of(c, call);
    int code = check(a);
    if (code) {
        take_back(c);
        return code;
    }
    a->o.call = CALL_Start;
    struct request *r = request_new();
    struct prepared *p = get_memory(sizeof *p);
    *p = (struct prepared){*a, run};
    args_keep(a);
    p->args.types = types_keep(a->buf == MPI_IN_PLACE ? NULL : a->types, a->o.size);
    p->args.ases = types_keep(a->ases, a->o.size);
    r->what = COLLECTS, r->persistent = true, r->comm = c, r->prepared = p;
    c->object.users++;
    *request = HANDLE(MPI_Request, r);
    return MPI_SUCCESS;
}

void coll_restart(struct request *r)
{
    r->active = true;
    r->task = task_start(r->prepared->run, &r->prepared->args);
}

int coll_call(struct args *a, int call, MPI_Comm comm, coll_run *check, coll_run *run, MPI_Request *request)
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(call);
    a->o = coll_of(c, call);
    int code = check(a);
    if (code) {
        take_back(c);
        return code;
    }
    if (!request)
        return run(a);
    struct request *r = request_new();
    r->what = COLLECTS, r->active = true, r->comm = c;
    c->object.users++;
    status_empty(&r->status);
    r->task = task_start(run, a);
    *request = HANDLE(MPI_Request, r);
    return MPI_SUCCESS;
}

int coll_check_root(const struct coll *o, int root)
{
    bool none = o->c->remote && (root == MPI_ROOT || root == MPI_PROC_NULL);
    if (none || (root >= 0 && root < o->size))
        return MPI_SUCCESS;
    return fail(o->c, o->call, MPI_ERR_ROOT, "root %d is not one of the communicator's ranks (0 to %d)", root,
                o->size - 1);
}

int coll_check(const struct coll *o, int count, MPI_Datatype t)
{
    if (count < 0)
        return fail(o->c, o->call, MPI_ERR_COUNT, "the count %d is negative", count);
    if (!type_is_valid(t))
        return fail(o->c, o->call, MPI_ERR_TYPE, "the datatype is null, freed, or not committed");
    return MPI_SUCCESS;
}

/* Does the rank's own part of one buffer begin where the other does? */
static bool has_same_places(const struct args *a)
{
    const int *places = a->at ? a->at : a->places;
    return a->at && a->places ? a->at == a->places : !places || places[a->o.rank] == 0;
}

/* They begin at one place. Parts of other types or at other places may lie apart all the same, and there may
 * be no elements. */
int coll_fail_same(const struct args *a)
{
    bool same = (a->op || a->type == a->as) && a->types == a->ases && has_same_places(a);
    bool any = any_bytes(a->count, a->type);
    for (int i = 0; a->counts && i < a->o.size; i++)
        any = any || a->counts[i] > 0;
    if (a->o.c->remote || !same || !any)
        return MPI_SUCCESS;
    return fail(a->o.c, a->o.call, MPI_ERR_BUFFER,
                "what is sent and what is received are the same memory: give MPI_IN_PLACE for one of them");
}

/* The rank's part of what it gathers or scatters. */
static bool lies_in_place(const struct args *a)
{
    int rank = a->o.rank, sent = a->counts ? a->counts[rank] : a->count;
    int received = a->rooms ? a->rooms[rank] : a->room;
    int place = a->counts ? a->at[rank] : a->rooms ? a->places[rank] : rank;
    return place == 0 && sent == received && a->type == a->as;
}

int coll_fail_part(const struct args *a)
{
    bool fatal = a->o.c->handler == MPI_ERRORS_ARE_FATAL;
    return fatal && lies_in_place(a) ? MPI_SUCCESS : coll_fail_same(a);
}

/* --- messages --- */

static struct nxm_envelope envelope(const struct coll *o, int peer)
{
    return (struct nxm_envelope){o->call, o->tag, group_node(o->group, peer), o->c->context + 1};
}

struct request *coll_start(const struct coll *o, bool sends, void *buf, int count, MPI_Datatype t, int peer)
{
    struct request *r = request_new();
    r->what = sends ? SENDS : RECEIVES, r->mode = READY;
    r->comm = o->c, r->peer = peer;
    o->c->object.users++;
    type_keep(t);
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
        tasks_complete(&(struct nxm_completion){o->call, NXM_WAIT, count, ids, status});
    for (int i = 0; i < count; i++) {
        int one = r[i] ? request_finish(r[i], o->call, &status[i], NULL) : MPI_SUCCESS;
        code = one ? one : code;
    }
    free(ids);
    free(status);
    return code;
}

void coll_send(const struct coll *o, const void *buf, int count, MPI_Datatype t, int to)
{
    size_t bytes;
    const struct nxm_envelope e = envelope(o, to);
    const void *at = type_together(buf, count, t, &bytes);
    char *packed = at || !bytes ? NULL : get_memory(bytes);
    if (packed)
        type_pack(buf, count, t, packed);
    int id = (int)nxm_isend(&e, at ? at : packed, (long)bytes, false);
    if (id)
        tasks_complete(&(struct nxm_completion){o->call, NXM_WAIT, 1, &id, &(struct nxm_status){0}});
    give_memory(packed);
}

static int too_long(const struct coll *o, const struct nxm_status *s, size_t room)
{
    return fail(o->c, o->call, MPI_ERR_TRUNCATE,
                "rank %d sends %ld bytes, but this one expects %zu: counts, datatypes or calls differ, as "
                "touchstone run --mpi-checks says",
                group_rank_of(o->group, s->node), s->bytes, room);
}

int coll_receive(const struct coll *o, void *buf, int count, MPI_Datatype t, int from)
{
    size_t room;
    struct nxm_status s;
    const struct nxm_envelope e = envelope(o, from);
    void *at = type_together(buf, count, t, &room);
    char *packed = at || !room ? NULL : get_memory(room);
    tasks_receive(&e, at ? at : packed, room, &s);
    if (packed && !s.truncated)
        type_unpack(packed, (size_t)s.bytes, buf, count, t);
    give_memory(packed);
    return s.truncated ? too_long(o, &s, room) : MPI_SUCCESS;
}

int coll_exchange(const struct coll *o, const void *buf, int count, MPI_Datatype t, int to, void *into,
                  int room, MPI_Datatype as, int from)
{
    struct request *r[2] = {coll_start(o, false, into, room, as, from),
                            coll_start(o, true, (void *)(uintptr_t)buf, count, t, to)};
    return coll_wait(o, 2, r);
}
