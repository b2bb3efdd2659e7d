/* groups.c - ordered sets of processes. Those of consecutive nodes have no list. */
#include <stdlib.h>
#include <string.h>
#include "lib.h"
#include "nx.h"

static struct group empty = {.object = {GROUP, 1, 0}, .rank = -1};

struct group *group_of(MPI_Group handle)
{
    return handle == MPI_GROUP_EMPTY ? &empty : object_of(handle, GROUP);
}

struct group *group_new(int size)
{
    struct group *g = object_new(GROUP, sizeof *g);
    g->size = size, g->rank = -1;
    g->nodes = get_memory((size_t)size * sizeof *g->nodes);
    return g;
}

struct group *group_done(struct group *g)
{
    bool consecutive = true;
    int me = (int)mynode();
    for (int i = 0; i < g->size; i++) {
        consecutive = consecutive && g->nodes[i] == g->nodes[0] + i;
        if (g->nodes[i] == me)
            g->rank = i;
    }
    if (consecutive && g->size) {
        g->first = g->nodes[0];
        free(g->nodes);
        g->nodes = NULL;
    }
    return g;
}

void group_leave(struct group *g)
{
    if (g && g != &empty && object_leave(&g->object) && g != comm_world.local && g != comm_self.local) {
        free(g->nodes);
        free(g);
    }
}

int group_rank_in_list(const struct group *g, int node)
{
    for (int i = 0; i < g->size; i++)
        if (g->nodes[i] == node)
            return i;
    return MPI_UNDEFINED;
}

static int no_group(int call)
{
    return fail(NULL, call, MPI_ERR_GROUP, "the group is null, or freed");
}

static MPI_Group handle_of(struct group *g)
{
    if (g->size)
        return HANDLE(MPI_Group, g);
    group_leave(g);
    return MPI_GROUP_EMPTY;
}

/* --- asking --- */

CALL(Group_size, (MPI_Group group, int *size))
{
    const struct group *g = group_of(group);
    if (!g)
        return no_group(CALL_Group_size);
    if (!size)
        return fail_answer(NULL, CALL_Group_size);
    *size = g->size;
    return MPI_SUCCESS;
}

CALL(Group_rank, (MPI_Group group, int *rank))
{
    const struct group *g = group_of(group);
    if (!g)
        return no_group(CALL_Group_rank);
    if (!rank)
        return fail_answer(NULL, CALL_Group_rank);
    *rank = g->rank < 0 ? MPI_UNDEFINED : g->rank;
    return MPI_SUCCESS;
}

CALL(Group_translate_ranks, (MPI_Group from, int count, const int ranks[], MPI_Group to, int translated[]))
{
    const struct group *a = group_of(from), *b = group_of(to);
    if (!a || !b)
        return no_group(CALL_Group_translate_ranks);
    if (count > 0 && (!ranks || !translated))
        return fail_answer(NULL, CALL_Group_translate_ranks);
    for (int i = 0; i < count; i++) {
        if (ranks[i] != MPI_PROC_NULL && (ranks[i] < 0 || ranks[i] >= a->size))
            return fail(NULL, CALL_Group_translate_ranks, MPI_ERR_RANK,
                        "rank %d is not one of the group's %d", ranks[i], a->size);
        translated[i] = ranks[i] == MPI_PROC_NULL ? MPI_PROC_NULL : group_rank_of(b, group_node(a, ranks[i]));
    }
    return MPI_SUCCESS;
}

int group_compare(const struct group *a, const struct group *b)
{
    bool same = a->size == b->size;
    if (a->size != b->size)
        return MPI_UNEQUAL;
    for (int i = 0; i < a->size; i++) {
        same = same && group_node(a, i) == group_node(b, i);
        if (group_rank_of(b, group_node(a, i)) == MPI_UNDEFINED)
            return MPI_UNEQUAL;
    }
    return same ? MPI_IDENT : MPI_SIMILAR;
}

CALL(Group_compare, (MPI_Group a, MPI_Group b, int *result))
{
    if (!group_of(a) || !group_of(b))
        return no_group(CALL_Group_compare);
    if (!result)
        return fail_answer(NULL, CALL_Group_compare);
    *result = group_compare(group_of(a), group_of(b));
    return MPI_SUCCESS;
}

/* --- making --- */

static void add(struct group *g, int *size, int node)
{
    g->nodes[(*size)++] = node;
}

/* Those of a, then those of b that are not in a. */
CALL(Group_union, (MPI_Group a, MPI_Group b, MPI_Group *group))
{
    const struct group *x = group_of(a), *y = group_of(b);
    int size = 0;
    if (!x || !y)
        return no_group(CALL_Group_union);
    if (!group)
        return fail_answer(NULL, CALL_Group_union);
    struct group *g = group_new(x->size + y->size);
    for (int i = 0; i < x->size; i++)
        add(g, &size, group_node(x, i));
    for (int i = 0; i < y->size; i++)
        if (group_rank_of(x, group_node(y, i)) == MPI_UNDEFINED)
            add(g, &size, group_node(y, i));
    g->size = size;
    *group = handle_of(group_done(g));
    return MPI_SUCCESS;
}

/* Those of a that are in b, or that are not. */
static struct group *select_of(const struct group *a, const struct group *b, bool in)
{
    struct group *g = group_new(a->size);
    int size = 0;
    for (int i = 0; i < a->size; i++)
        if ((group_rank_of(b, group_node(a, i)) != MPI_UNDEFINED) == in)
            add(g, &size, group_node(a, i));
    g->size = size;
    return group_done(g);
}

CALL(Group_intersection, (MPI_Group a, MPI_Group b, MPI_Group *group))
{
    if (!group_of(a) || !group_of(b))
        return no_group(CALL_Group_intersection);
    if (!group)
        return fail_answer(NULL, CALL_Group_intersection);
    *group = handle_of(select_of(group_of(a), group_of(b), true));
    return MPI_SUCCESS;
}

CALL(Group_difference, (MPI_Group a, MPI_Group b, MPI_Group *group))
{
    if (!group_of(a) || !group_of(b))
        return no_group(CALL_Group_difference);
    if (!group)
        return fail_answer(NULL, CALL_Group_difference);
    *group = handle_of(select_of(group_of(a), group_of(b), false));
    return MPI_SUCCESS;
}

/* 0, or the error: a rank that is none, or is given twice. Marks those given. */
static int mark(const struct group *g, int call, int rank, bool *given)
{
    if (rank < 0 || rank >= g->size)
        return fail(NULL, call, MPI_ERR_RANK, "rank %d is not one of the group's %d", rank, g->size);
    if (given[rank])
        return fail(NULL, call, MPI_ERR_RANK, "rank %d is given twice", rank);
    return given[rank] = true, MPI_SUCCESS;
}

/* The ranks in order, or all others. */
static int choose(int call, MPI_Group from, int count, const int ranks[], bool others, MPI_Group *group)
{
    const struct group *f = group_of(from);
    int size = 0, code = MPI_SUCCESS;
    if (!f)
        return no_group(call);
    if (!group)
        return fail_answer(NULL, call);
    if (count < 0)
        return fail(NULL, call, MPI_ERR_ARG, "the count %d is negative", count);
    bool *given = calloc((size_t)f->size + 1, sizeof *given);
    for (int i = 0; i < count && !code; i++)
        code = mark(f, call, ranks[i], given);
    if (!code) {
        struct group *g = group_new(others ? f->size : count);
        for (int i = 0; i < count && !others; i++)
            add(g, &size, group_node(f, ranks[i]));
        for (int r = 0; r < f->size && others; r++)
            if (!given[r])
                add(g, &size, group_node(f, r));
        g->size = size;
        *group = handle_of(group_done(g));
    }
    free(given);
    return code;
}

CALL(Group_incl, (MPI_Group from, int count, const int ranks[], MPI_Group *group))
{
    return choose(CALL_Group_incl, from, count, ranks, false, group);
}

CALL(Group_excl, (MPI_Group from, int count, const int ranks[], MPI_Group *group))
{
    return choose(CALL_Group_excl, from, count, ranks, true, group);
}

/* Adds the ranks of a range to a list, one more than there is room for at most: then one is none, or given
 * twice. */
static int add_range(int *ranks, int k, int room, const int range[3])
{
    for (long r = range[0]; k <= room && (range[2] > 0 ? r <= range[1] : r >= range[1]); r += range[2])
        ranks[k++] = (int)r;
    return k;
}

static int choose_ranges(int call, MPI_Group from, int count, int ranges[][3], bool others, MPI_Group *group)
{
    const struct group *f = group_of(from);
    if (!f)
        return no_group(call);
    for (int i = 0; i < count; i++)
        if (!ranges[i][2])
            return fail(NULL, call, MPI_ERR_ARG, "a stride of 0");
    int *ranks = get_memory(((size_t)f->size + 1) * sizeof *ranks), k = 0;
    for (int i = 0; i < count; i++)
        k = add_range(ranks, k, f->size, ranges[i]);
    int code = choose(call, from, count < 0 ? count : k, ranks, others, group);
    free(ranks);
    return code;
}

CALL(Group_range_incl, (MPI_Group from, int count, int ranges[][3], MPI_Group *group))
{
    return choose_ranges(CALL_Group_range_incl, from, count, ranges, false, group);
}

CALL(Group_range_excl, (MPI_Group from, int count, int ranges[][3], MPI_Group *group))
{
    return choose_ranges(CALL_Group_range_excl, from, count, ranges, true, group);
}

CALL(Group_free, (MPI_Group * group))
{
    struct group *g = group_of(*group);
    if (!g)
        return no_group(CALL_Group_free);
    group_leave(g);
    *group = MPI_GROUP_NULL;
    return MPI_SUCCESS;
}

/* --- of communicators --- */

struct group *group_keep(struct group *g)
{
    if (g->object.handle) {
        g->object.users++;
        return g;
    }
    struct group *copy = object_new(GROUP, sizeof *copy); /* of MPI_COMM_WORLD's or MPI_COMM_SELF's */
    copy->size = g->size, copy->rank = g->rank, copy->first = g->first;
    return copy;
}

CALL(Comm_group, (MPI_Comm comm, MPI_Group *group))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Comm_group);
    if (!group)
        return fail_answer(c, CALL_Comm_group);
    *group = HANDLE(MPI_Group, group_keep(c->local));
    return MPI_SUCCESS;
}

CALL(Comm_remote_group, (MPI_Comm comm, MPI_Group *group))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Comm_remote_group);
    if (!group)
        return fail_answer(c, CALL_Comm_remote_group);
    if (!c->remote)
        return fail(c, CALL_Comm_remote_group, MPI_ERR_COMM, "the communicator has one group only");
    *group = HANDLE(MPI_Group, group_keep(c->remote));
    return MPI_SUCCESS;
}
