/* comms.c - communicators: a group, or two, and a context. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "coll.h"

/* --- handles --- */

struct comm *comm_of(MPI_Comm handle)
{
    if (!mpi_runs)
        return NULL;
    if (handle == MPI_COMM_WORLD)
        return &comm_world;
    return handle == MPI_COMM_SELF ? &comm_self : object_of(handle, COMM);
}

/* Where the next communicator's context may be, on this process. */
static int next_context = NXM_FIRST_CONTEXT + 4;

struct comm *comm_new(struct group *local, struct group *remote, int context)
{
    struct comm *c = object_new(COMM, sizeof *c);
    c->local = local, c->remote = remote, c->peers = remote ? remote : local;
    c->context = context;
    c->handler = MPI_ERRORS_ARE_FATAL;
    return c;
}

int comm_agree_context(struct comm *c, int call)
{
    const struct coll o = {c, call};
    int context;
    coll_allreduce(&o, &next_context, &context, 1, MPI_INT, MPI_MAX);
    next_context = context + 2;
    return context;
}

static struct group *keep(struct group *g)
{
    if (g->object.handle) {
        g->object.users++;
        return g;
    }
    struct group *copy = object_new(GROUP, sizeof *copy);
    copy->size = g->size, copy->rank = g->rank, copy->first = g->first;
    return copy;
}

static void drop(struct comm *c)
{
    if (!object_leave(&c->object))
        return;
    group_leave(c->local);
    group_leave(c->remote);
    topology_free(c->topology);
    free(c->name);
    free(c);
}

/* --- asking --- */

#define ASK(name, type, expression)                                                                          \
    CALL(name, (MPI_Comm comm, type *value))                                                                 \
    {                                                                                                        \
        const struct comm *c = comm_of(comm);                                                                \
        if (!c)                                                                                              \
            return fail_comm(CALL_Other);                                                                    \
        *value = (expression);                                                                               \
        return MPI_SUCCESS;                                                                                  \
    }
ASK(Comm_size, int, c->local->size)
ASK(Comm_rank, int, c->local->rank)
ASK(Comm_test_inter, int, c->remote != NULL)

CALL(Comm_remote_size, (MPI_Comm comm, int *size))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Other);
    if (!c->remote)
        return fail(c, CALL_Other, MPI_ERR_COMM, "MPI_Comm_remote_size: the communicator has one group only");
    *size = c->remote->size;
    return MPI_SUCCESS;
}

static int compare(const struct group *a, const struct group *b)
{
    MPI_Group x = HANDLE(MPI_Group, a), y = HANDLE(MPI_Group, b);
    int same = a->size == b->size;
    (void)x, (void)y;
    for (int i = 0; i < a->size && same; i++)
        same = group_node(a, i) == group_node(b, i);
    if (same)
        return MPI_CONGRUENT;
    for (int i = 0; i < a->size; i++)
        if (a->size != b->size || group_rank_of(b, group_node(a, i)) == MPI_UNDEFINED)
            return MPI_UNEQUAL;
    return a->size == b->size ? MPI_SIMILAR : MPI_UNEQUAL;
}

CALL(Comm_compare, (MPI_Comm a, MPI_Comm b, int *result))
{
    const struct comm *x = comm_of(a), *y = comm_of(b);
    if (!x || !y)
        return fail_comm(CALL_Other);
    if (x == y)
        *result = MPI_IDENT;
    else if (!x->remote != !y->remote)
        *result = MPI_UNEQUAL;
    else
        *result = compare(x->local, y->local);
    if (x != y && x->remote && y->remote) {
        int other = compare(x->remote, y->remote);
        *result = other > *result ? other : *result;
    }
    return MPI_SUCCESS;
}

CALL(Comm_set_name, (MPI_Comm comm, const char *name))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Other);
    free(c->name);
    c->name = strndup(name, MPI_MAX_OBJECT_NAME - 1);
    return MPI_SUCCESS;
}

CALL(Comm_get_name, (MPI_Comm comm, char *name, int *length))
{
    struct comm *c = comm_of(comm);
    if (!c && comm != MPI_COMM_NULL)
        return fail_comm(CALL_Other);
    const char *own = !c ? "MPI_COMM_NULL" : c == &comm_world ? "MPI_COMM_WORLD" : c == &comm_self ? "MPI_COMM_SELF" : "";
    *length = snprintf(name, MPI_MAX_OBJECT_NAME, "%s", c && c->name ? c->name : own);
    return MPI_SUCCESS;
}

CALL(Comm_set_info, (MPI_Comm comm, MPI_Info info))
{
    (void)info;
    return comm_of(comm) ? MPI_SUCCESS : fail_comm(CALL_Other);
}

CALL(Comm_get_info, (MPI_Comm comm, MPI_Info *info))
{
    return comm_of(comm) ? PMPI_Info_create(info) : fail_comm(CALL_Other);
}

CALL(Comm_get_parent, (MPI_Comm * parent))
{
    *parent = MPI_COMM_NULL;
    return MPI_SUCCESS;
}

/* --- making and ending --- */

/* What a copy has of the one it is made from. */
static void inherit(struct comm *c, const struct comm *from)
{
    MPI_Comm handle = HANDLE(MPI_Comm, c);
    PMPI_Comm_set_errhandler(handle, from->handler);
}

/* The bigger of the contexts that the two groups' processes could use, known to all. */
static int agree_between(struct comm *c, int call);

CALL(Comm_dup, (MPI_Comm comm, MPI_Comm *to))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Comm_dup);
    int context = c->remote ? agree_between(c, CALL_Comm_dup) : comm_agree_context(c, CALL_Comm_dup);
    struct comm *copy = comm_new(keep(c->local), c->remote ? keep(c->remote) : NULL, context);
    inherit(copy, c);
    copy->topology = topology_copy(c->topology);
    int code = comm_copy_attributes(c, copy);
    if (code) {
        drop(copy);
        *to = MPI_COMM_NULL;
        return fail(c, CALL_Comm_dup, code, "an attribute's copy function says no");
    }
    *to = HANDLE(MPI_Comm, copy);
    return MPI_SUCCESS;
}

CALL(Comm_dup_with_info, (MPI_Comm comm, MPI_Info info, MPI_Comm *to))
{
    (void)info;
    return PMPI_Comm_dup(comm, to);
}

CALL(Comm_create, (MPI_Comm comm, MPI_Group group, MPI_Comm *to))
{
    struct comm *c = comm_of(comm);
    struct group *g = group_of(group);
    if (!c)
        return fail_comm(CALL_Comm_create);
    if (!g)
        return fail(c, CALL_Comm_create, MPI_ERR_GROUP, "the group is null, or freed");
    if (c->remote)
        return fail(c, CALL_Comm_create, MPI_ERR_COMM, "not for communicators of two groups");
    for (int i = 0; i < g->size; i++)
        if (group_rank_of(c->local, group_node(g, i)) == MPI_UNDEFINED)
            return fail(c, CALL_Comm_create, MPI_ERR_GROUP,
                        "node %d of the group is not in the communicator", group_node(g, i));
    int context = comm_agree_context(c, CALL_Comm_create);
    *to = MPI_COMM_NULL;
    if (g->rank < 0)
        return MPI_SUCCESS;
    struct comm *made = comm_new(keep(g), NULL, context);
    inherit(made, c);
    *to = HANDLE(MPI_Comm, made);
    return MPI_SUCCESS;
}

/* Collective over the group alone, which has no context yet: in the parent's, one after the other. */
static int agree_in_group(struct comm *c, const struct group *g)
{
    const struct coll o = {c, CALL_Comm_create_group};
    int context = next_context, theirs;
    int first = group_rank_of(c->local, group_node(g, 0));
    if (g->rank > 0) {
        coll_send_bytes(&o, &context, sizeof context, first);
        coll_receive_bytes(&o, &context, sizeof context, first);
    } else {
        for (int i = 1; i < g->size; i++) {
            coll_receive_bytes(&o, &theirs, sizeof theirs, group_rank_of(c->local, group_node(g, i)));
            context = theirs > context ? theirs : context;
        }
        for (int i = 1; i < g->size; i++)
            coll_send_bytes(&o, &context, sizeof context, group_rank_of(c->local, group_node(g, i)));
    }
    next_context = context + 2;
    return context;
}

CALL(Comm_create_group, (MPI_Comm comm, MPI_Group group, int tag, MPI_Comm *to))
{
    struct comm *c = comm_of(comm);
    struct group *g = group_of(group);
    (void)tag;
    if (!c)
        return fail_comm(CALL_Comm_create_group);
    if (!g)
        return fail(c, CALL_Comm_create_group, MPI_ERR_GROUP, "the group is null, or freed");
    *to = MPI_COMM_NULL;
    if (g->rank < 0)
        return MPI_SUCCESS;
    struct comm *made = comm_new(keep(g), NULL, agree_in_group(c, g));
    inherit(made, c);
    *to = HANDLE(MPI_Comm, made);
    return MPI_SUCCESS;
}

/* --- splitting --- */

struct choice {
    int color, key, rank;
};

static int by_key(const void *x, const void *y)
{
    const struct choice *a = x, *b = y;
    return a->key != b->key ? (a->key < b->key ? -1 : 1) : a->rank - b->rank;
}

/* Those of the same color, by key and rank. */
static struct group *group_of_color(const struct group *all, struct choice *choices, int color)
{
    int size = 0;
    for (int i = 0; i < all->size; i++)
        if (choices[i].color == color)
            choices[size++] = choices[i];
    qsort(choices, (size_t)size, sizeof *choices, by_key);
    struct group *g = group_new(size);
    for (int i = 0; i < size; i++)
        g->nodes[i] = group_node(all, choices[i].rank);
    return group_done(g);
}

CALL(Comm_split, (MPI_Comm comm, int color, int key, MPI_Comm *to))
{
    struct coll o;
    int code = coll_begin(&o, CALL_Comm_split, comm);
    if (code)
        return code;
    if (color < 0 && color != MPI_UNDEFINED)
        return fail(o.c, CALL_Comm_split, MPI_ERR_ARG, "the color %d is negative", color);
    struct choice own = {color, key, coll_rank(&o)};
    struct choice *choices = get_memory((size_t)coll_size(&o) * sizeof *choices);
    coll_allgather_bytes(&o, &own, sizeof own, choices);
    int context = comm_agree_context(o.c, CALL_Comm_split);
    *to = MPI_COMM_NULL;
    if (color != MPI_UNDEFINED) {
        struct comm *made = comm_new(group_of_color(o.c->local, choices, color), NULL, context);
        inherit(made, o.c);
        *to = HANDLE(MPI_Comm, made);
    }
    free(choices);
    return MPI_SUCCESS;
}

/* No two nodes share memory. */
CALL(Comm_split_type, (MPI_Comm comm, int kind, int key, MPI_Info info, MPI_Comm *to))
{
    struct comm *c = comm_of(comm);
    (void)info;
    if (!c)
        return fail_comm(CALL_Comm_split);
    return PMPI_Comm_split(comm, kind == MPI_UNDEFINED ? MPI_UNDEFINED : c->local->rank, key, to);
}

CALL(Comm_free, (MPI_Comm * comm))
{
    struct comm *c = comm_of(*comm);
    if (!c)
        return fail_comm(CALL_Comm_free);
    if (c == &comm_world || c == &comm_self)
        return fail(c, CALL_Comm_free, MPI_ERR_COMM, "MPI_COMM_WORLD and MPI_COMM_SELF cannot be freed");
    int code = comm_delete_attributes(c);
    if (code)
        return fail(c, CALL_Comm_free, code, "an attribute's delete function says no");
    drop(c);
    *comm = MPI_COMM_NULL;
    return MPI_SUCCESS;
}

CALL(Comm_disconnect, (MPI_Comm * comm))
{
    return PMPI_Comm_free(comm);
}

/* --- communicators of two groups --- */

/* The leaders of the two groups tell each other, in point to point's context of a communicator. */
static void leaders_exchange(struct comm *bridge, int call, int tag, int leader, const void *own, int bytes,
                             void *theirs)
{
    struct nxm_envelope e = {call, tag, group_node(bridge->peers, leader), bridge->context};
    struct nxm_status status;
    long id = nxm_irecv(&e, theirs, bytes);
    nxm_send(&e, own, bytes, false);
    nxm_complete(&(struct nxm_completion){call, NXM_WAIT, 1, &(int){(int)id}, &status});
}

/* The local groups agree; then the leaders; then all are told. */
static int agree_between(struct comm *c, int call)
{
    struct comm inside = *c;
    inside.remote = NULL, inside.peers = inside.local;
    const struct coll o = {&inside, call};
    int context, theirs;
    coll_allreduce(&o, &next_context, &context, 1, MPI_INT, MPI_MAX);
    if (c->local->rank == 0) {
        struct comm other = *c;
        other.context++; /* of collectives, in which nobody else is now */
        leaders_exchange(&other, call, MPI_CALLS, 0, &context, sizeof context, &theirs);
        context = theirs > context ? theirs : context;
    }
    coll_bcast(&o, &context, 1, MPI_INT, 0);
    next_context = context + 2;
    return context;
}

/* What a leader tells the other of its group. */
struct offer {
    int size, context;
};

static struct group *exchange_groups(const struct coll *o, bool leads, struct comm *bridge, int remote_leader,
                                     int tag, struct offer *theirs)
{
    struct offer own = {coll_size(o), next_context};
    coll_allreduce(o, &next_context, &own.context, 1, MPI_INT, MPI_MAX);
    if (leads)
        leaders_exchange(bridge, CALL_Intercomm_create, tag, remote_leader, &own, sizeof own, theirs);
    int leader = -1;
    int mine = leads ? coll_rank(o) : -1;
    coll_allreduce(o, &mine, &leader, 1, MPI_INT, MPI_MAX);
    coll_bcast(o, theirs, 2, MPI_INT, leader);
    struct group *g = group_new(theirs->size);
    if (leads) {
        int *nodes = get_memory((size_t)own.size * sizeof *nodes);
        for (int i = 0; i < own.size; i++)
            nodes[i] = group_node(o->c->local, i);
        struct nxm_envelope e = {CALL_Intercomm_create, tag, group_node(bridge->peers, remote_leader),
                                 bridge->context};
        struct nxm_status status;
        long id = nxm_irecv(&e, g->nodes, (long)sizeof *nodes * theirs->size);
        nxm_send(&e, nodes, (long)sizeof *nodes * own.size, false);
        nxm_complete(&(struct nxm_completion){CALL_Intercomm_create, NXM_WAIT, 1, &(int){(int)id}, &status});
        free(nodes);
    }
    coll_bcast(o, g->nodes, theirs->size, MPI_INT, leader);
    theirs->context = own.context > theirs->context ? own.context : theirs->context;
    return group_done(g);
}

CALL(Intercomm_create,
     (MPI_Comm local, int leader, MPI_Comm bridge, int remote_leader, int tag, MPI_Comm *to))
{
    struct coll o;
    struct offer theirs = {0, 0};
    int code = coll_begin(&o, CALL_Intercomm_create, local);
    if (code)
        return code;
    if (leader < 0 || leader >= coll_size(&o))
        return fail(o.c, CALL_Intercomm_create, MPI_ERR_RANK, "leader %d is not one of %d ranks", leader,
                    coll_size(&o));
    bool leads = coll_rank(&o) == leader;
    struct comm *b = leads ? comm_of(bridge) : NULL;
    if (leads && !b)
        return fail_comm(CALL_Intercomm_create);
    struct group *remote = exchange_groups(&o, leads, b, remote_leader, tag, &theirs);
    next_context = theirs.context + 2;
    struct comm *made = comm_new(keep(o.c->local), remote, theirs.context);
    inherit(made, o.c);
    *to = HANDLE(MPI_Comm, made);
    return MPI_SUCCESS;
}

/* The low group's ranks come first; of equal ones, those of the lower first node. */
CALL(Intercomm_merge, (MPI_Comm comm, int high, MPI_Comm *to))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Intercomm_merge);
    if (!c->remote)
        return fail(c, CALL_Intercomm_merge, MPI_ERR_COMM, "the communicator has one group only");
    struct comm inside = *c;
    inside.remote = NULL, inside.peers = inside.local;
    const struct coll o = {&inside, CALL_Intercomm_merge};
    int context = agree_between(c, CALL_Intercomm_merge), theirs = 0, own = high != 0;
    if (c->local->rank == 0) {
        struct comm other = *c;
        other.context++;
        leaders_exchange(&other, CALL_Intercomm_merge, MPI_CALLS, 0, &own, sizeof own, &theirs);
    }
    coll_bcast(&o, &theirs, 1, MPI_INT, 0);
    bool first = own != theirs ? own < theirs : group_node(c->local, 0) < group_node(c->remote, 0);
    const struct group *a = first ? c->local : c->remote, *b = first ? c->remote : c->local;
    struct group *g = group_new(a->size + b->size);
    for (int i = 0; i < g->size; i++)
        g->nodes[i] = i < a->size ? group_node(a, i) : group_node(b, i - a->size);
    struct comm *made = comm_new(group_done(g), NULL, context);
    inherit(made, c);
    *to = HANDLE(MPI_Comm, made);
    return MPI_SUCCESS;
}
