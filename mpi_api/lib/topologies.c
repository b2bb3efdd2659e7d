/* topologies.c - grids and graphs of ranks. Ranks are not reordered: a rank is where its node is. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include "topologies.h"

static int *copy_of(const int *list, int count)
{
    int *copy = get_memory((size_t)count * sizeof *copy);
    if (count)
        memcpy(copy, list, (size_t)count * sizeof *copy);
    return copy;
}

static struct topology *grid_new(int dims, const int sides[], const int periods[])
{
    struct topology *t = calloc(1, sizeof *t);
    t->kind = MPI_CART, t->dims = dims;
    t->sides = copy_of(sides, dims), t->periods = copy_of(periods, dims);
    return t;
}

struct topology *topology_of_neighbors(int ins, const int sources[], const int *in_weights, int outs,
                                       const int dests[], const int *out_weights)
{
    struct topology *t = calloc(1, sizeof *t);
    t->kind = MPI_DIST_GRAPH, t->edge_count = ins, t->outs = outs;
    t->edges = copy_of(sources, ins), t->dests = copy_of(dests, outs);
    t->weighted = in_weights != MPI_UNWEIGHTED && out_weights != MPI_UNWEIGHTED;
    if (t->weighted) {
        t->in_weights = copy_of(in_weights, ins);
        t->out_weights = copy_of(out_weights, outs);
    }
    return t;
}

static struct topology *graph_new(int nodes, const int ends[], const int edges[])
{
    struct topology *t = calloc(1, sizeof *t);
    t->kind = MPI_GRAPH, t->nodes = nodes, t->edge_count = nodes ? ends[nodes - 1] : 0;
    t->ends = copy_of(ends, nodes), t->edges = copy_of(edges, t->edge_count);
    return t;
}

struct topology *topology_copy(const struct topology *t)
{
    if (!t)
        return NULL;
    if (t->kind == MPI_CART)
        return grid_new(t->dims, t->sides, t->periods);
    if (t->kind == MPI_GRAPH)
        return graph_new(t->nodes, t->ends, t->edges);
    return topology_of_neighbors(t->edge_count, t->edges, t->weighted ? t->in_weights : MPI_UNWEIGHTED,
                                 t->outs, t->dests, t->out_weights);
}

void topology_free(struct topology *t)
{
    if (!t)
        return;
    free(t->sides);
    free(t->periods);
    free(t->ends);
    free(t->edges);
    free(t->dests);
    free(t->in_weights);
    free(t->out_weights);
    free(t);
}

/* The communicator's grid or graph; NULL with *code: it has none. */
const struct topology *topology_of(int call, MPI_Comm comm, int kind, int *code)
{
    struct comm *c = comm_of(comm);
    const struct topology *t = c ? c->topology : NULL;
    if (!c)
        *code = fail_comm(call);
    else if (!t || t->kind != kind)
        *code = fail(c, call, MPI_ERR_TOPOLOGY, "the communicator has no %s",
                     kind == MPI_CART ? "grid" : "graph");
    return t && t->kind == kind ? t : NULL;
}

CALL(Topo_test, (MPI_Comm comm, int *kind))
{
    const struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Topo_test);
    *kind = c->topology ? c->topology->kind : MPI_UNDEFINED;
    return MPI_SUCCESS;
}

/* --- grids --- */

/* Sides that make n, none longer than the one before or than `limit`, the first as short as can be. */
static bool find_sides(int n, int dims, int limit, int sides[])
{
    if (!dims)
        return n == 1;
    for (int side = 1; side <= limit && side <= n; side++) {
        double volume = 1;
        for (int d = 0; d < dims; d++)
            volume *= side;
        if (n % side == 0 && volume >= n && find_sides(n / side, dims - 1, side, sides + 1))
            return *sides = side, true;
    }
    return false;
}

CALL(Dims_create, (int nodes, int dims, int sides[]))
{
    int open = 0, n = 0;
    long given = 1;
    if (nodes < 1 || dims < 0)
        return fail(NULL, CALL_Dims_create, MPI_ERR_DIMS, "%d nodes in %d dimensions", nodes, dims);
    for (int d = 0; d < dims; d++) {
        if (sides[d] < 0)
            return fail(NULL, CALL_Dims_create, MPI_ERR_DIMS, "side %d is %d", d, sides[d]);
        given *= sides[d] && given <= nodes ? sides[d] : 1;
        open += !sides[d];
    }
    if (nodes % given)
        return fail(NULL, CALL_Dims_create, MPI_ERR_DIMS,
                    "%d nodes are no multiple of the %ld that the given sides make", nodes, given);
    int found[open + 1];
    find_sides(nodes / (int)given, open, nodes, found);
    for (int d = 0; d < dims; d++)
        if (!sides[d])
            sides[d] = found[n++];
    return MPI_SUCCESS;
}

/* (Of more than there can be, as many as there are when they become too many.) */
static long ranks_of(int dims, const int sides[])
{
    long ranks = 1;
    for (int d = 0; d < dims && ranks <= INT_MAX; d++)
        ranks *= sides[d];
    return ranks;
}

/* A communicator of the first ranks, with a topology, which it takes over. */
int topology_make(const struct coll *o, int ranks, struct topology *t, MPI_Comm *to)
{
    int color = o->rank < ranks ? 0 : MPI_UNDEFINED;
    int context = comm_agree_context(o);
    *to = MPI_COMM_NULL;
    if (color == MPI_UNDEFINED) {
        topology_free(t);
        return MPI_SUCCESS;
    }
    struct group *g = group_new(ranks);
    for (int i = 0; i < ranks; i++)
        g->nodes[i] = group_node(o->c->local, i);
    struct comm *c = comm_new(group_done(g), NULL, context);
    c->topology = t;
    *to = HANDLE(MPI_Comm, c);
    PMPI_Comm_set_errhandler(*to, o->c->handler);
    return MPI_SUCCESS;
}

CALL(Cart_create,
     (MPI_Comm comm, int dims, const int sides[], const int periods[], int reorder, MPI_Comm *to))
{
    struct comm *c = comm_of(comm);
    (void)reorder;
    if (!c || c->remote)
        return fail_groups(c, CALL_Cart_create);
    const struct coll o = coll_of(c, CALL_Cart_create);
    *to = MPI_COMM_NULL;
    for (int d = 0; d < dims; d++)
        if (sides[d] < 1)
            return fail(o.c, CALL_Cart_create, MPI_ERR_DIMS, "side %d of the grid is %d", d, sides[d]);
    if (dims < 0 || ranks_of(dims, sides) > o.size)
        return fail(o.c, CALL_Cart_create, MPI_ERR_DIMS, "the grid has %ld ranks, the communicator %d",
                    ranks_of(dims, sides), o.size);
    return topology_make(&o, (int)ranks_of(dims, sides), grid_new(dims, sides, periods), to);
}

void topology_coords(const struct topology *t, int rank, int coords[])
{
    for (int d = t->dims - 1; d >= 0; d--) {
        coords[d] = rank % t->sides[d];
        rank /= t->sides[d];
    }
}

/* MPI_PROC_NULL: outside of a side that is not periodic. */
int topology_rank_at(const struct topology *t, const int coords[])
{
    int rank = 0;
    for (int d = 0; d < t->dims; d++) {
        int side = t->sides[d], c = coords[d];
        if ((c < 0 || c >= side) && !t->periods[d])
            return MPI_PROC_NULL;
        rank = rank * side + ((c % side) + side) % side;
    }
    return rank;
}

CALL(Cart_coords, (MPI_Comm comm, int rank, int most, int coords[]))
{
    int code;
    const struct topology *t = topology_of(CALL_Cart_coords, comm, MPI_CART, &code);
    if (!t)
        return code;
    if (rank < 0 || rank >= ranks_of(t->dims, t->sides) || most < t->dims)
        return fail(comm_of(comm), CALL_Cart_coords, rank < 0 || most >= t->dims ? MPI_ERR_RANK : MPI_ERR_ARG,
                    "rank %d, room for %d of %d coordinates", rank, most, t->dims);
    topology_coords(t, rank, coords);
    return MPI_SUCCESS;
}

CALL(Cart_rank, (MPI_Comm comm, const int coords[], int *rank))
{
    int code;
    const struct topology *t = topology_of(CALL_Cart_rank, comm, MPI_CART, &code);
    if (!t)
        return code;
    *rank = topology_rank_at(t, coords);
    if (*rank == MPI_PROC_NULL)
        return fail(comm_of(comm), CALL_Cart_rank, MPI_ERR_ARG, "the coordinates lie outside of the grid");
    return MPI_SUCCESS;
}

CALL(Cart_shift, (MPI_Comm comm, int direction, int by, int *source, int *dest))
{
    int code;
    const struct topology *t = topology_of(CALL_Cart_shift, comm, MPI_CART, &code);
    if (!t)
        return code;
    if (direction < 0 || direction >= t->dims)
        return fail(comm_of(comm), CALL_Cart_shift, MPI_ERR_ARG, "direction %d of %d", direction, t->dims);
    int coords[t->dims];
    topology_coords(t, comm_of(comm)->local->rank, coords);
    coords[direction] += by;
    *dest = topology_rank_at(t, coords);
    coords[direction] -= 2 * by;
    *source = topology_rank_at(t, coords);
    return MPI_SUCCESS;
}

CALL(Cart_get, (MPI_Comm comm, int most, int sides[], int periods[], int coords[]))
{
    int code;
    const struct topology *t = topology_of(CALL_Cart_get, comm, MPI_CART, &code);
    if (!t)
        return code;
    int own[t->dims + 1];
    topology_coords(t, comm_of(comm)->local->rank, own);
    for (int d = 0; d < t->dims && d < most; d++)
        sides[d] = t->sides[d], periods[d] = t->periods[d] != 0, coords[d] = own[d];
    return MPI_SUCCESS;
}

CALL(Cartdim_get, (MPI_Comm comm, int *dims))
{
    int code;
    const struct topology *t = topology_of(CALL_Cartdim_get, comm, MPI_CART, &code);
    if (!t)
        return code;
    *dims = t->dims;
    return MPI_SUCCESS;
}

CALL(Cart_map, (MPI_Comm comm, int dims, const int sides[], const int periods[], int *rank))
{
    const struct comm *c = comm_of(comm);
    (void)periods;
    if (!c)
        return fail_comm(CALL_Cart_map);
    *rank = c->local->rank < ranks_of(dims, sides) ? c->local->rank : MPI_UNDEFINED;
    return MPI_SUCCESS;
}

/* Those whose coordinates in the other dimensions are the same. */
CALL(Cart_sub, (MPI_Comm comm, const int keep[], MPI_Comm *to))
{
    int code, color = 0, key = 0, dims = 0;
    const struct topology *t = topology_of(CALL_Cart_sub, comm, MPI_CART, &code);
    if (!t)
        return code;
    int coords[t->dims + 1], sides[t->dims + 1], periods[t->dims + 1];
    topology_coords(t, comm_of(comm)->local->rank, coords);
    for (int d = 0; d < t->dims; d++) {
        if (keep[d]) {
            key = key * t->sides[d] + coords[d];
            sides[dims] = t->sides[d], periods[dims++] = t->periods[d];
        } else {
            color = color * t->sides[d] + coords[d];
        }
    }
    if (!dims && comm_of(comm)->local->rank)
        color = MPI_UNDEFINED; /* as MPICH has it: one rank is left */
    code = PMPI_Comm_split(comm, color, key, to);
    if (!code && *to != MPI_COMM_NULL)
        comm_of(*to)->topology = grid_new(dims, sides, periods);
    return code;
}

/* --- graphs --- */

CALL(Graph_create, (MPI_Comm comm, int nodes, const int ends[], const int edges[], int reorder, MPI_Comm *to))
{
    struct comm *c = comm_of(comm);
    (void)reorder;
    if (!c || c->remote)
        return fail_groups(c, CALL_Graph_create);
    const struct coll o = coll_of(c, CALL_Graph_create);
    if (nodes < 0 || nodes > o.size)
        return fail(o.c, CALL_Graph_create, MPI_ERR_ARG, "the graph has %d nodes, the communicator %d ranks",
                    nodes, o.size);
    for (int i = 0; i < nodes; i++)
        if (ends[i] < (i ? ends[i - 1] : 0))
            return fail(o.c, CALL_Graph_create, MPI_ERR_ARG, "node %d's edges end before they begin, at %d",
                        i, ends[i]);
    for (int i = 0; nodes && i < ends[nodes - 1]; i++)
        if (edges[i] < 0 || edges[i] >= nodes)
            return fail(o.c, CALL_Graph_create, MPI_ERR_ARG,
                        "edge %d leads to %d, which is no node of the graph", i, edges[i]);
    return topology_make(&o, nodes, graph_new(nodes, ends, edges), to);
}

CALL(Graphdims_get, (MPI_Comm comm, int *nodes, int *edges))
{
    int code;
    const struct topology *t = topology_of(CALL_Graphdims_get, comm, MPI_GRAPH, &code);
    if (!t)
        return code;
    *nodes = t->nodes, *edges = t->edge_count;
    return MPI_SUCCESS;
}

CALL(Graph_get, (MPI_Comm comm, int most_nodes, int most_edges, int ends[], int edges[]))
{
    int code;
    const struct topology *t = topology_of(CALL_Graph_get, comm, MPI_GRAPH, &code);
    if (!t)
        return code;
    for (int i = 0; i < t->nodes && i < most_nodes; i++)
        ends[i] = t->ends[i];
    for (int i = 0; i < t->edge_count && i < most_edges; i++)
        edges[i] = t->edges[i];
    return MPI_SUCCESS;
}

static int first_edge(const struct topology *t, int rank)
{
    return rank ? t->ends[rank - 1] : 0;
}

CALL(Graph_neighbors_count, (MPI_Comm comm, int rank, int *count))
{
    int code;
    const struct topology *t = topology_of(CALL_Graph_neighbors_count, comm, MPI_GRAPH, &code);
    if (!t)
        return code;
    if (rank < 0 || rank >= t->nodes)
        return fail(comm_of(comm), CALL_Graph_neighbors_count, MPI_ERR_RANK, "rank %d of %d", rank, t->nodes);
    *count = t->ends[rank] - first_edge(t, rank);
    return MPI_SUCCESS;
}

CALL(Graph_neighbors, (MPI_Comm comm, int rank, int most, int neighbors[]))
{
    int code;
    const struct topology *t = topology_of(CALL_Graph_neighbors, comm, MPI_GRAPH, &code);
    if (!t)
        return code;
    if (rank < 0 || rank >= t->nodes)
        return fail(comm_of(comm), CALL_Graph_neighbors, MPI_ERR_RANK, "rank %d of %d", rank, t->nodes);
    for (int i = first_edge(t, rank), n = 0; i < t->ends[rank] && n < most; i++, n++)
        neighbors[n] = t->edges[i];
    return MPI_SUCCESS;
}

CALL(Graph_map, (MPI_Comm comm, int nodes, const int ends[], const int edges[], int *rank))
{
    const struct comm *c = comm_of(comm);
    (void)ends, (void)edges;
    if (!c)
        return fail_comm(CALL_Graph_map);
    *rank = c->local->rank < nodes ? c->local->rank : MPI_UNDEFINED;
    return MPI_SUCCESS;
}
