/* neighbors.c - graphs of which each rank knows its own part, and collectives between neighbours. */
#include <stdlib.h>
#include "topologies.h"

/* --- graphs --- */

/* Lists of ranks, which may have MPI_PROC_NULL. */
static int check_ranks(const struct coll *o, int count, const int ranks[])
{
    if (count < 0)
        return fail(o->c, o->call, MPI_ERR_ARG, "the count %d is negative", count);
    for (int i = 0; i < count; i++)
        if (ranks[i] != MPI_PROC_NULL && (ranks[i] < 0 || ranks[i] >= o->size))
            return fail(o->c, o->call, MPI_ERR_RANK,
                        "there is no rank %d in the communicator (ranks are 0 to %d)", ranks[i], o->size - 1);
    return MPI_SUCCESS;
}

CALL(Dist_graph_create_adjacent,
     (MPI_Comm comm, int ins, const int sources[], const int *in_weights, int outs, const int dests[],
      const int *out_weights, MPI_Info info, int reorder, MPI_Comm *to))
{
    struct comm *c = comm_of(comm);
    (void)info, (void)reorder;
    if (!c || c->remote)
        return fail_groups(c, CALL_Dist_graph_create_adjacent);
    const struct coll o = coll_of(c, CALL_Dist_graph_create_adjacent);
    int code = check_ranks(&o, ins, sources);
    code = code ? code : check_ranks(&o, outs, dests);
    if (code)
        return code;
    struct topology *t = topology_of_neighbors(ins, sources, in_weights, outs, dests, out_weights);
    return topology_make(&o, o.size, t, to);
}

struct edge {
    int source, dest, weight;
};

/* All edges that any rank has given. */
static struct edge *gather_edges(const struct coll *o, const struct edge *own, int count, int *total)
{
    int *counts = get_memory(2 * (size_t)o->size * sizeof *counts), *at = counts + o->size;
    coll_allgather_bytes(o, &count, sizeof count, counts);
    *total = 0;
    for (int i = 0; i < o->size; i++) {
        at[i] = *total;
        *total += counts[i];
    }
    struct edge *all = get_memory(((size_t)*total + 1) * sizeof *all);
    for (int i = 0; i < count; i++)
        all[at[o->rank] + i] = own[i];
    for (int i = 0; i < o->size; i++)
        coll_bcast(o, all + at[i], counts[i] * (int)sizeof *all, MPI_BYTE, i);
    free(counts);
    return all;
}

static struct topology *neighbors_of(const struct edge *all, int total, int rank, bool weighted)
{
    int *lists = get_memory(4 * ((size_t)total + 1) * sizeof *lists), ins = 0, outs = 0;
    int *sources = lists, *in_weights = lists + total, *dests = lists + 2 * total,
        *out_weights = lists + 3 * total;
    for (int i = 0; i < total; i++) {
        if (all[i].dest == rank)
            sources[ins] = all[i].source, in_weights[ins++] = all[i].weight;
        if (all[i].source == rank)
            dests[outs] = all[i].dest, out_weights[outs++] = all[i].weight;
    }
    struct topology *t =
        topology_of_neighbors(ins, sources, weighted ? in_weights : MPI_UNWEIGHTED, outs, dests, out_weights);
    free(lists);
    return t;
}

CALL(Dist_graph_create, (MPI_Comm comm, int count, const int sources[], const int degrees[],
                         const int dests[], const int *weights, MPI_Info info, int reorder, MPI_Comm *to))
{
    struct comm *c = comm_of(comm);
    bool weighted = weights != MPI_UNWEIGHTED;
    int edges = 0, total, n = 0;
    (void)info, (void)reorder;
    if (!c || c->remote)
        return fail_groups(c, CALL_Dist_graph_create);
    const struct coll o = coll_of(c, CALL_Dist_graph_create);
    int code = check_ranks(&o, count, sources);
    for (int i = 0; i < count && !code; i++) {
        code = check_ranks(&o, degrees[i], dests + edges);
        edges += degrees[i];
    }
    if (code)
        return code;
    struct edge *own = get_memory(((size_t)edges + 1) * sizeof *own);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < degrees[i]; k++, n++)
            own[n] = (struct edge){sources[i], dests[n], weighted && edges ? weights[n] : 0};
    struct edge *all = gather_edges(&o, own, edges, &total);
    struct topology *t = neighbors_of(all, total, o.rank, weighted);
    free(own);
    free(all);
    return topology_make(&o, o.size, t, to);
}

CALL(Dist_graph_neighbors_count, (MPI_Comm comm, int *ins, int *outs, int *weighted))
{
    int code;
    const struct topology *t = topology_of(CALL_Dist_graph_neighbors_count, comm, MPI_DIST_GRAPH, &code);
    if (!t)
        return code;
    *ins = t->edge_count, *outs = t->outs, *weighted = t->weighted;
    return MPI_SUCCESS;
}

CALL(Dist_graph_neighbors, (MPI_Comm comm, int most_ins, int sources[], int *in_weights, int most_outs,
                            int dests[], int *out_weights))
{
    int code;
    const struct topology *t = topology_of(CALL_Dist_graph_neighbors, comm, MPI_DIST_GRAPH, &code);
    if (!t)
        return code;
    for (int i = 0; i < t->edge_count && i < most_ins; i++) {
        sources[i] = t->edges[i];
        if (t->weighted && in_weights != MPI_UNWEIGHTED)
            in_weights[i] = t->in_weights[i];
    }
    for (int i = 0; i < t->outs && i < most_outs; i++) {
        dests[i] = t->dests[i];
        if (t->weighted && out_weights != MPI_UNWEIGHTED)
            out_weights[i] = t->out_weights[i];
    }
    return MPI_SUCCESS;
}

/* --- who the neighbours are --- */

struct neighbors {
    int ins, outs, *in, *out;
};

/* On a grid: in each dimension, the one before and the one behind. */
static void grid_neighbors(const struct topology *t, int rank, struct neighbors *n)
{
    int *coords = get_memory((size_t)t->dims * sizeof *coords);
    n->in = n->out = get_memory((size_t)n->ins * sizeof *n->in);
    topology_coords(t, rank, coords);
    for (int d = 0; d < t->dims; d++) {
        coords[d]--;
        n->in[2 * d] = topology_rank_at(t, coords);
        coords[d] += 2;
        n->in[2 * d + 1] = topology_rank_at(t, coords);
        coords[d]--;
    }
    free(coords);
}

/* So many, in, and out; their lists, but for a grid. */
static struct neighbors listed_neighbors(const struct coll *o)
{
    const struct topology *t = o->c->topology;
    if (t->kind == MPI_CART)
        return (struct neighbors){2 * t->dims, 2 * t->dims, NULL, NULL};
    if (t->kind != MPI_GRAPH)
        return (struct neighbors){t->edge_count, t->outs, t->edges, t->dests};
    int first = o->rank ? t->ends[o->rank - 1] : 0, count = t->ends[o->rank] - first;
    return (struct neighbors){count, count, t->edges + first, t->edges + first};
}

static struct neighbors neighbors(const struct coll *o)
{
    struct neighbors n = listed_neighbors(o);
    if (o->c->topology->kind == MPI_CART)
        grid_neighbors(o->c->topology, o->rank, &n);
    return n;
}

/* --- the collectives --- */

/* The counts and types of all parts: lists, or the same for all. */
static int check_parts(const struct coll *o, int parts, const int *counts, int count,
                       const MPI_Datatype *types, MPI_Datatype type)
{
    int code = MPI_SUCCESS;
    for (int i = 0; i < (counts ? parts : 1) && !code; i++)
        code = coll_check(o, counts ? counts[i] : count, types ? types[i] : type);
    return code;
}

static int check_exchange(struct args *a)
{
    if (!a->o.c->topology)
        return fail(a->o.c, a->o.call, MPI_ERR_TOPOLOGY, "the communicator has neither a grid nor a graph");
    struct neighbors n = listed_neighbors(&a->o);
    int code = check_parts(&a->o, n.outs, a->counts, a->count, a->types, a->type);
    return code ? code : check_parts(&a->o, n.ins, a->rooms, a->room, a->ases, a->as);
}

/* Where the i-th part lies. */
static void *part(const void *buf, const int *counts, const int *at, const MPI_Aint *addresses, int count,
                  MPI_Datatype t, int i, bool same)
{
    if (addresses)
        return (char *)(uintptr_t)buf + addresses[i];
    return element(buf, same ? 0 : counts ? at[i] : (MPI_Aint)i * count, t);
}

static int exchange(struct args *a)
{
    const struct coll *o = &a->o;
    struct neighbors n = neighbors(o);
    struct request **r = get_memory(((size_t)n.ins + (size_t)n.outs) * sizeof *r);
    int count = 0;
    for (int i = 0; i < n.ins; i++) {
        MPI_Datatype as = a->ases ? a->ases[i] : a->as;
        void *at = part(a->into, a->rooms, a->places, a->in_addresses, a->room, as, i, false);
        if (n.in[i] != MPI_PROC_NULL)
            r[count++] = coll_start(o, false, at, a->rooms ? a->rooms[i] : a->room, as, n.in[i]);
    }
    for (int k = 0; k < n.outs; k++) {
        /* On a grid the one behind first: if it is the one before, too, it receives in that order. */
        int i = o->c->topology->kind == MPI_CART ? k ^ 1 : k;
        MPI_Datatype t = a->types ? a->types[i] : a->type;
        void *at = part(a->buf, a->counts, a->at, a->out_addresses, a->count, t, i, a->same);
        if (n.out[i] != MPI_PROC_NULL)
            r[count++] = coll_start(o, true, at, a->counts ? a->counts[i] : a->count, t, n.out[i]);
    }
    int code = coll_wait(o, count, r);
    free(r);
    if (o->c->topology->kind == MPI_CART)
        free(n.in);
    return code;
}

#define NEIGHBOR(name, parameters, ...)                                                                      \
    CALL(Neighbor_##name, (COLL_LIST parameters MPI_Comm comm))                                              \
    {                                                                                                        \
        struct args a = {__VA_ARGS__};                                                                       \
        return coll_call(&a, CALL_Neighbor_##name, comm, check_exchange, exchange, NULL);                    \
    }                                                                                                        \
    CALL(Ineighbor_##name, (COLL_LIST parameters MPI_Comm comm, MPI_Request * request))                      \
    {                                                                                                        \
        struct args a = {__VA_ARGS__};                                                                       \
        return coll_call(&a, CALL_Ineighbor_##name, comm, check_exchange, exchange, request);                \
    }

#define EQUAL const void *buf, int count, MPI_Datatype type, void *into, int room, MPI_Datatype as
#define EQUALS .buf = buf, .count = count, .type = type, .into = into, .room = room, .as = as
NEIGHBOR(allgather, (EQUAL), EQUALS, .same = true)
NEIGHBOR(alltoall, (EQUAL), EQUALS)
NEIGHBOR(allgatherv,
         (const void *buf, int count, MPI_Datatype type, void *into, const int rooms[], const int places[],
          MPI_Datatype as),
         .buf = buf, .count = count, .type = type, .into = into, .rooms = rooms, .places = places, .as = as,
         .same = true)
NEIGHBOR(alltoallv,
         (const void *buf, const int counts[], const int at[], MPI_Datatype type, void *into,
          const int rooms[], const int places[], MPI_Datatype as),
         .buf = buf, .counts = counts, .at = at, .type = type, .into = into, .rooms = rooms, .places = places,
         .as = as)
NEIGHBOR(alltoallw,
         (const void *buf, const int counts[], const MPI_Aint at[], const MPI_Datatype types[], void *into,
          const int rooms[], const MPI_Aint places[], const MPI_Datatype as[]),
         .buf = buf, .counts = counts, .out_addresses = at, .types = types, .into = into, .rooms = rooms,
         .in_addresses = places, .ases = as)
