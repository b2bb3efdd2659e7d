/* comms.c - communicators: a group, or two, and a context. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "coll.h"

/* --- handles --- */

/* A context that no other communicator has: of this process's own. */
static int context_new(void)
{
    static int made;
    return NXM_FIRST_CONTEXT + 4 + 2 * (made++ * comm_world.local->size + comm_world.local->rank);
}

struct comm *comm_new(struct group *local, struct group *remote, int context)
{
    struct comm *c = object_new(COMM, sizeof *c);
    c->local = local, c->remote = remote, c->peers = remote ? remote : local;
    c->context = context;
    c->handler = MPI_ERRORS_ARE_FATAL;
    return c;
}

int comm_agree_context(const struct coll *o)
{
    int context = o->rank ? 0 : context_new();
    coll_bcast(o, &context, 1, MPI_INT, 0);
    return context;
}

/* Of both groups: that of the one whose first node is lower. */
static int agree_between(const struct coll *o)
{
    const struct coll in = coll_inside(o);
    int context = 0;
    if (!o->rank && group_node(o->c->local, 0) < group_node(o->c->remote, 0)) {
        context = context_new();
        coll_send_bytes(o, &context, sizeof context, 0);
    } else if (!o->rank) {
        coll_receive_bytes(o, &context, sizeof context, 0);
    }
    coll_bcast(&in, &context, 1, MPI_INT, 0);
    return context;
}

/* The last user has gone. */
void comm_end(struct comm *c)
{
    group_leave(c->local);
    group_leave(c->remote);
    topology_free(c->topology);
    PMPI_Errhandler_free(&c->handler);
    free(c->name);
    free(c);
}

/* --- asking --- */

#define ASK(name, type, expression)                                                                          \
    CALL(name, (MPI_Comm comm, type * value))                                                                \
    {                                                                                                        \
        const struct comm *c = comm_of(comm);                                                                \
        if (!c)                                                                                              \
            return fail_comm(CALL_##name);                                                                   \
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
        return fail_comm(CALL_Comm_remote_size);
    if (!c->remote)
        return fail(c, CALL_Comm_remote_size, MPI_ERR_COMM, "the communicator has one group only");
    *size = c->remote->size;
    return MPI_SUCCESS;
}

/* Of two communicators, which are not the same. */
static int alike(const struct group *a, const struct group *b)
{
    int groups = group_compare(a, b);
    return groups == MPI_IDENT ? MPI_CONGRUENT : groups;
}

CALL(Comm_compare, (MPI_Comm a, MPI_Comm b, int *result))
{
    const struct comm *x = comm_of(a), *y = comm_of(b);
    if (!x || !y)
        return fail_comm(CALL_Comm_compare);
    if (x == y)
        *result = MPI_IDENT;
    else if (!x->remote != !y->remote)
        *result = MPI_UNEQUAL;
    else
        *result = alike(x->local, y->local);
    if (x != y && x->remote && y->remote) {
        int other = alike(x->remote, y->remote);
        *result = other > *result ? other : *result;
    }
    return MPI_SUCCESS;
}

CALL(Comm_set_name, (MPI_Comm comm, const char *name))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Comm_set_name);
    free(c->name);
    c->name = strndup(name, MPI_MAX_OBJECT_NAME - 1);
    return MPI_SUCCESS;
}

CALL(Comm_get_name, (MPI_Comm comm, char *name, int *length))
{
    struct comm *c = comm_of(comm);
    if (!c && comm != MPI_COMM_NULL)
        return fail_comm(CALL_Comm_get_name);
    const char *own = !c                 ? "MPI_COMM_NULL"
                      : c == &comm_world ? "MPI_COMM_WORLD"
                      : c == &comm_self  ? "MPI_COMM_SELF"
                                         : "";
    *length = snprintf(name, MPI_MAX_OBJECT_NAME, "%s", c && c->name ? c->name : own);
    return MPI_SUCCESS;
}

CALL(Comm_set_info, (MPI_Comm comm, MPI_Info info))
{
    (void)info;
    return comm_of(comm) ? MPI_SUCCESS : fail_comm(CALL_Comm_set_info);
}

CALL(Comm_get_info, (MPI_Comm comm, MPI_Info *info))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Comm_get_info);
    return info ? PMPI_Info_create(info) : fail_answer(c, CALL_Comm_get_info);
}

CALL(Comm_get_parent, (MPI_Comm * parent))
{
    *parent = MPI_COMM_NULL;
    return MPI_SUCCESS;
}

/* --- making and ending --- */

static struct comm *inherit(struct comm *c, const struct comm *from)
{
    PMPI_Comm_set_errhandler(HANDLE(MPI_Comm, c), from->handler);
    return c;
}

static int check_nothing(struct args *a)
{
    (void)a;
    return MPI_SUCCESS;
}

/* The copy is there already; its context is agreed on now. */
static int agree_on_copy(struct args *a)
{
    struct comm *copy = a->into;
    copy->context = a->o.c->remote ? agree_between(&a->o) : comm_agree_context(&a->o);
    return MPI_SUCCESS;
}

static int duplicate(int call, MPI_Comm comm, MPI_Comm *to, MPI_Request *request)
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(call);
    struct comm *copy =
        inherit(comm_new(group_keep(c->local), c->remote ? group_keep(c->remote) : NULL, 0), c);
    struct args a = {.into = copy};
    copy->topology = topology_copy(c->topology);
    int code = comm_copy_attributes(c, copy);
    *to = code ? MPI_COMM_NULL : HANDLE(MPI_Comm, copy);
    if (!code)
        return coll_call(&a, call, comm, check_nothing, agree_on_copy, request);
    comm_leave(copy);
    return fail(c, call, code, "an attribute's copy function says no");
}

CALL(Comm_dup, (MPI_Comm comm, MPI_Comm *to))
{
    return duplicate(CALL_Comm_dup, comm, to, NULL);
}

CALL(Comm_idup, (MPI_Comm comm, MPI_Comm *to, MPI_Request *request))
{
    return duplicate(CALL_Comm_idup, comm, to, request);
}

CALL(Comm_dup_with_info, (MPI_Comm comm, MPI_Info info, MPI_Comm *to))
{
    (void)info;
    return duplicate(CALL_Comm_dup_with_info, comm, to, NULL);
}

CALL(Comm_idup_with_info, (MPI_Comm comm, MPI_Info info, MPI_Comm *to, MPI_Request *request))
{
    (void)info;
    return duplicate(CALL_Comm_idup_with_info, comm, to, request);
}

/* --- a part of a communicator --- */

/* Is each of g in the communicator's own group? */
static bool is_within(const struct group *g, const struct group *all)
{
    for (int i = 0; i < g->size; i++)
        if (group_rank_of(all, group_node(g, i)) == MPI_UNDEFINED)
            return false;
    return true;
}

/* The two groups tell each other which part they choose; each may be empty. */
static struct group *exchange_parts(const struct coll *o, const struct group *own)
{
    const struct coll in = coll_inside(o);
    int size = own->size, theirs = 0;
    if (!o->rank)
        coll_exchange(o, &size, 1, MPI_INT, 0, &theirs, 1, MPI_INT, 0);
    coll_bcast(&in, &theirs, 1, MPI_INT, 0);
    struct group *g = group_new(theirs);
    int *nodes = get_memory((size_t)size * sizeof *nodes);
    for (int i = 0; i < size; i++)
        nodes[i] = group_node(own, i);
    if (!o->rank)
        coll_exchange(o, nodes, size, MPI_INT, 0, g->nodes, theirs, MPI_INT, 0);
    free(nodes);
    coll_bcast(&in, g->nodes, theirs, MPI_INT, 0);
    return group_done(g);
}

CALL(Comm_create, (MPI_Comm comm, MPI_Group group, MPI_Comm *to))
{
    struct comm *c = comm_of(comm);
    struct group *g = group_of(group), *remote = NULL;
    if (!c)
        return fail_comm(CALL_Comm_create);
    if (!to)
        return fail_answer(c, CALL_Comm_create);
    if (!g || !is_within(g, c->local))
        return fail(c, CALL_Comm_create, MPI_ERR_GROUP, "the group is %s",
                    g ? "no part of the communicator's" : "null, or freed");
    struct coll o = coll_of(c, CALL_Comm_create);
    if (c->remote)
        remote = exchange_parts(&o, g);
    int context = c->remote ? agree_between(&o) : comm_agree_context(&o);
    *to = MPI_COMM_NULL;
    if (g->rank < 0 || (remote && !remote->size))
        return group_leave(remote), MPI_SUCCESS;
    *to = HANDLE(MPI_Comm, inherit(comm_new(group_keep(g), remote, context), c));
    return MPI_SUCCESS;
}

/* Only the group's processes take part: the first tells the others, by a tag of its own. */
CALL(Comm_create_group, (MPI_Comm comm, MPI_Group group, int tag, MPI_Comm *to))
{
    enum { FIRST_TAG = 900000000, TAGS = 99999999 };
    struct comm *c = comm_of(comm);
    struct group *g = group_of(group);
    if (!c)
        return fail_comm(CALL_Comm_create_group);
    if (!to)
        return fail_answer(c, CALL_Comm_create_group);
    if (!g)
        return fail(c, CALL_Comm_create_group, MPI_ERR_GROUP, "the group is null, or freed");
    if (tag < 0)
        return fail(c, CALL_Comm_create_group, MPI_ERR_TAG, "the tag %d is negative", tag);
    *to = MPI_COMM_NULL;
    if (g->rank < 0)
        return MPI_SUCCESS;
    const struct coll o = {c, CALL_Comm_create_group, FIRST_TAG + tag % TAGS, g, g->size, g->rank};
    *to = HANDLE(MPI_Comm, inherit(comm_new(group_keep(g), NULL, comm_agree_context(&o)), c));
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
static struct group *group_of_color(const struct group *all, const struct choice *choices, int color)
{
    struct choice *own = get_memory((size_t)all->size * sizeof *own);
    int size = 0;
    for (int i = 0; i < all->size; i++)
        if (choices[i].color == color)
            own[size++] = choices[i];
    qsort(own, (size_t)size, sizeof *own, by_key);
    struct group *g = group_new(size);
    for (int i = 0; i < size; i++)
        g->nodes[i] = group_node(all, own[i].rank);
    free(own);
    return group_done(g);
}

/* What the ranks of the other group have chosen. */
static struct choice *choices_of_others(const struct coll *o, const struct choice *own, int count)
{
    const struct coll in = coll_inside(o);
    int numbers = (int)(sizeof *own / sizeof(int));
    struct choice *theirs = get_memory((size_t)o->size * sizeof *theirs);
    if (!o->rank)
        coll_exchange(o, own, numbers * count, MPI_INT, 0, theirs, numbers * o->size, MPI_INT, 0);
    coll_bcast(&in, theirs, numbers * o->size, MPI_INT, 0);
    return theirs;
}

CALL(Comm_split, (MPI_Comm comm, int color, int key, MPI_Comm *to))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Comm_split);
    if (!to)
        return fail_answer(c, CALL_Comm_split);
    if (color < 0 && color != MPI_UNDEFINED)
        return fail(c, CALL_Comm_split, MPI_ERR_ARG, "the color %d is negative", color);
    const struct coll o = coll_of(c, CALL_Comm_split), in = coll_inside(&o);
    struct choice own = {color, key, o.rank};
    struct choice *choices = get_memory((size_t)in.size * sizeof *choices), *others = NULL;
    struct group *remote = NULL;
    coll_allgather_bytes(&in, &own, sizeof own, choices);
    if (c->remote) {
        others = choices_of_others(&o, choices, in.size);
        remote = group_of_color(c->remote, others, color);
    }
    /* One context does for all parts: no process is in two. */
    int context = c->remote ? agree_between(&o) : comm_agree_context(&o);
    *to = MPI_COMM_NULL;
    if (color != MPI_UNDEFINED && (!remote || remote->size))
        *to =
            HANDLE(MPI_Comm, inherit(comm_new(group_of_color(c->local, choices, color), remote, context), c));
    else
        group_leave(remote);
    free(choices);
    free(others);
    return MPI_SUCCESS;
}

/* No two nodes share memory. */
CALL(Comm_split_type, (MPI_Comm comm, int kind, int key, MPI_Info info, MPI_Comm *to))
{
    struct comm *c = comm_of(comm);
    (void)info;
    if (!c)
        return fail_comm(CALL_Comm_split_type);
    if (kind != MPI_COMM_TYPE_SHARED && kind != MPI_UNDEFINED)
        return fail(c, CALL_Comm_split_type, MPI_ERR_ARG, "there is no kind of part %d", kind);
    if (!to)
        return fail_answer(c, CALL_Comm_split_type);
    return PMPI_Comm_split(comm, kind == MPI_UNDEFINED ? MPI_UNDEFINED : c->local->rank, key, to);
}

static int end(int call, MPI_Comm *comm)
{
    struct comm *c = comm_of(*comm);
    if (!c)
        return fail_comm(call);
    if (c == &comm_world || c == &comm_self)
        return fail(c, call, MPI_ERR_COMM, "MPI_COMM_WORLD and MPI_COMM_SELF cannot be freed");
    int code = comm_delete_attributes(c);
    if (code)
        return fail(c, call, code, "an attribute's delete function says no");
    comm_leave(c);
    *comm = MPI_COMM_NULL;
    return MPI_SUCCESS;
}

CALL(Comm_free, (MPI_Comm * comm))
{
    return end(CALL_Comm_free, comm);
}

CALL(Comm_disconnect, (MPI_Comm * comm))
{
    return end(CALL_Comm_disconnect, comm);
}

/* --- communicators of two groups --- */

/* The leaders tell each other, in point to point's half of the bridge's context. */
static void leaders_exchange(struct comm *bridge, int tag, int leader, const void *own, size_t bytes,
                             void *theirs, size_t room)
{
    struct nxm_envelope e = {CALL_Intercomm_create, tag, group_node(bridge->peers, leader), bridge->context};
    struct nxm_status status;
    int id = (int)nxm_irecv(&e, theirs, (long)room);
    nxm_send(&e, own, (long)bytes, false);
    nxm_complete(&(struct nxm_completion){CALL_Intercomm_create, NXM_WAIT, 1, &id, &status});
}

/* What a leader tells the other of its group: a context that is its own. */
struct offer {
    int size, context, node;
};

CALL(Intercomm_create,
     (MPI_Comm local, int leader, MPI_Comm bridge, int remote_leader, int tag, MPI_Comm *to))
{
    struct comm *c = comm_of(local), *b = NULL;
    if (!c || c->remote)
        return fail_groups(c, CALL_Intercomm_create);
    if (!to)
        return fail_answer(c, CALL_Intercomm_create);
    const struct coll o = coll_of(c, CALL_Intercomm_create);
    if (leader < 0 || leader >= o.size)
        return fail(c, CALL_Intercomm_create, MPI_ERR_RANK, "leader %d is not one of %d ranks", leader,
                    o.size);
    bool leads = o.rank == leader;
    if (leads && !(b = comm_of(bridge)))
        return fail_comm(CALL_Intercomm_create);
    if (leads && (remote_leader < 0 || remote_leader >= b->peers->size))
        return fail(b, CALL_Intercomm_create, MPI_ERR_RANK, "the other leader %d is not one of %d ranks",
                    remote_leader, b->peers->size);
    if (leads && tag < 0)
        return fail(b, CALL_Intercomm_create, MPI_ERR_TAG, "the tag %d is negative", tag);
    struct offer own = {o.size, leads ? context_new() : 0, group_node(c->local, leader)}, theirs;
    if (leads)
        leaders_exchange(b, tag, remote_leader, &own, sizeof own, &theirs, sizeof theirs);
    if (leads && own.node < theirs.node)
        theirs.context = own.context;
    coll_bcast(&o, &theirs, (int)sizeof theirs, MPI_BYTE, leader);
    struct group *remote = group_new(theirs.size);
    if (leads) {
        int *nodes = get_memory((size_t)own.size * sizeof *nodes);
        for (int i = 0; i < own.size; i++)
            nodes[i] = group_node(c->local, i);
        leaders_exchange(b, tag, remote_leader, nodes, (size_t)own.size * sizeof *nodes, remote->nodes,
                         (size_t)theirs.size * sizeof *nodes);
        free(nodes);
    }
    coll_bcast(&o, remote->nodes, theirs.size, MPI_INT, leader);
    if (group_done(remote)->rank >= 0) {
        group_leave(remote);
        return fail(c, CALL_Intercomm_create, MPI_ERR_COMM, "rank %d is in both groups", o.rank);
    }
    *to = HANDLE(MPI_Comm, inherit(comm_new(group_keep(c->local), remote, theirs.context), c));
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
    const struct coll o = coll_of(c, CALL_Intercomm_merge), in = coll_inside(&o);
    int context = agree_between(&o), theirs = 0, own = high != 0;
    if (!o.rank)
        coll_exchange(&o, &own, 1, MPI_INT, 0, &theirs, 1, MPI_INT, 0);
    coll_bcast(&in, &theirs, 1, MPI_INT, 0);
    bool first = own != theirs ? own < theirs : group_node(c->local, 0) < group_node(c->remote, 0);
    const struct group *x = first ? c->local : c->remote, *y = first ? c->remote : c->local;
    struct group *g = group_new(x->size + y->size);
    for (int i = 0; i < g->size; i++)
        g->nodes[i] = i < x->size ? group_node(x, i) : group_node(y, i - x->size);
    *to = HANDLE(MPI_Comm, inherit(comm_new(group_done(g), NULL, context), c));
    return MPI_SUCCESS;
}
