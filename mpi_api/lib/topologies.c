/* topologies.c - grids and graphs of ranks. Ranks are not reordered: a rank is where its node is. */
#include <stdlib.h>
#include <string.h>
#include "coll.h"

struct topology {
    int kind;              /* MPI_CART, MPI_GRAPH */
    int dims, *sides;      /* of a grid */
    int *periods;          /* behind sides */
    int nodes, edge_count; /* of a graph */
    int *ends, *edges;     /* rank r's neighbours are edges[ends[r - 1]] to before edges[ends[r]] */
};

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
    return t->kind == MPI_CART ? grid_new(t->dims, t->sides, t->periods) : graph_new(t->nodes, t->ends, t->edges);
}

void topology_free(struct topology *t)
{
    if (!t)
        return;
    free(t->sides);
    free(t->periods);
    free(t->ends);
    free(t->edges);
    free(t);
}

/* The communicator's grid or graph; NULL with *code: it has none. */
static const struct topology *topology_of(const char *call, MPI_Comm comm, int kind, int *code)
{
    struct comm *c = comm_of(comm);
    const struct topology *t = c ? c->topology : NULL;
    if (!c)
        *code = fail_comm(CALL_Other);
    else if (!t || t->kind != kind)
        *code = fail(c, CALL_Other, MPI_ERR_TOPOLOGY, "%s: the communicator has no %s", call,
                     kind == MPI_CART ? "grid" : "graph");
    return t && t->kind == kind ? t : NULL;
}

CALL(Topo_test, (MPI_Comm comm, int *kind))
{
    const struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Other);
    *kind = c->topology ? c->topology->kind : MPI_UNDEFINED;
    return MPI_SUCCESS;
}

/* --- grids --- */

/* The largest factor of n that is at most the k-th root of it, or the smallest above: sides as equal as can be. */
static int side_near_root(int n, int k)
{
    int best = n;
    for (int side = 1; side <= n; side++) {
        long volume = 1;
        if (n % side)
            continue;
        for (int i = 0; i < k; i++)
            volume *= side < 46341 ? side : 46341;
        if (volume >= n) {
            best = side;
            break;
        }
    }
    return best;
}

CALL(Dims_create, (int nodes, int dims, int sides[]))
{
    int given = 1, open = 0, last = nodes;
    for (int d = 0; d < dims; d++) {
        if (sides[d] < 0)
            return fail(NULL, CALL_Other, MPI_ERR_DIMS, "MPI_Dims_create: side %d is %d", d, sides[d]);
        if (sides[d])
            given *= sides[d];
        open += !sides[d];
    }
    if (nodes % given || (!open && given != nodes))
        return fail(NULL, CALL_Other, MPI_ERR_DIMS,
                    "MPI_Dims_create: %d nodes are no multiple of the %d that the given sides make", nodes, given);
    int left = nodes / given;
    for (int d = 0; d < dims; d++)
        if (!sides[d]) {
            int side = open == 1 ? left : side_near_root(left, open);
            sides[d] = side <= last ? side : left;
            left /= sides[d];
            open--;
        }
    return MPI_SUCCESS;
}

static int ranks_of(int dims, const int sides[])
{
    int ranks = 1;
    for (int d = 0; d < dims; d++)
        ranks *= sides[d];
    return ranks;
}

/* A communicator of the first ranks, with a topology, which it takes over. */
static int make(const struct coll *o, int ranks, struct topology *t, MPI_Comm *to)
{
    int color = coll_rank(o) < ranks ? 0 : MPI_UNDEFINED;
    int context = comm_agree_context(o->c, o->call);
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

CALL(Cart_create, (MPI_Comm comm, int dims, const int sides[], const int periods[], int reorder, MPI_Comm *to))
{
    struct coll o;
    int code = coll_begin(&o, CALL_Cart_create, comm);
    (void)reorder;
    if (code)
        return code;
    for (int d = 0; d < dims; d++)
        if (sides[d] < 1)
            return fail(o.c, CALL_Cart_create, MPI_ERR_DIMS, "side %d of the grid is %d", d, sides[d]);
    if (dims < 0 || ranks_of(dims, sides) > coll_size(&o))
        return fail(o.c, CALL_Cart_create, MPI_ERR_DIMS, "the grid has %d ranks, the communicator %d",
                    ranks_of(dims, sides), coll_size(&o));
    return make(&o, ranks_of(dims, sides), grid_new(dims, sides, periods), to);
}

static void coords_of(const struct topology *t, int rank, int coords[])
{
    for (int d = t->dims - 1; d >= 0; d--) {
        coords[d] = rank % t->sides[d];
        rank /= t->sides[d];
    }
}

/* MPI_PROC_NULL: outside of a side that is not periodic. */
static int rank_at(const struct topology *t, const int coords[])
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
    const struct topology *t = topology_of("MPI_Cart_coords", comm, MPI_CART, &code);
    if (!t)
        return code;
    if (rank < 0 || rank >= ranks_of(t->dims, t->sides) || most < t->dims)
        return fail(comm_of(comm), CALL_Other, rank < 0 || most >= t->dims ? MPI_ERR_RANK : MPI_ERR_ARG,
                    "MPI_Cart_coords: rank %d, room for %d of %d coordinates", rank, most, t->dims);
    coords_of(t, rank, coords);
    return MPI_SUCCESS;
}

CALL(Cart_rank, (MPI_Comm comm, const int coords[], int *rank))
{
    int code;
    const struct topology *t = topology_of("MPI_Cart_rank", comm, MPI_CART, &code);
    if (!t)
        return code;
    *rank = rank_at(t, coords);
    if (*rank == MPI_PROC_NULL)
        return fail(comm_of(comm), CALL_Other, MPI_ERR_ARG, "MPI_Cart_rank: the coordinates lie outside of the grid");
    return MPI_SUCCESS;
}

CALL(Cart_shift, (MPI_Comm comm, int direction, int by, int *source, int *dest))
{
    int code;
    const struct topology *t = topology_of("MPI_Cart_shift", comm, MPI_CART, &code);
    if (!t)
        return code;
    if (direction < 0 || direction >= t->dims)
        return fail(comm_of(comm), CALL_Other, MPI_ERR_ARG, "MPI_Cart_shift: direction %d of %d", direction, t->dims);
    int coords[t->dims];
    coords_of(t, comm_of(comm)->local->rank, coords);
    coords[direction] += by;
    *dest = rank_at(t, coords);
    coords[direction] -= 2 * by;
    *source = rank_at(t, coords);
    return MPI_SUCCESS;
}

CALL(Cart_get, (MPI_Comm comm, int most, int sides[], int periods[], int coords[]))
{
    int code;
    const struct topology *t = topology_of("MPI_Cart_get", comm, MPI_CART, &code);
    if (!t)
        return code;
    int own[t->dims + 1];
    coords_of(t, comm_of(comm)->local->rank, own);
    for (int d = 0; d < t->dims && d < most; d++)
        sides[d] = t->sides[d], periods[d] = t->periods[d] != 0, coords[d] = own[d];
    return MPI_SUCCESS;
}

CALL(Cartdim_get, (MPI_Comm comm, int *dims))
{
    int code;
    const struct topology *t = topology_of("MPI_Cartdim_get", comm, MPI_CART, &code);
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
        return fail_comm(CALL_Other);
    *rank = c->local->rank < ranks_of(dims, sides) ? c->local->rank : MPI_UNDEFINED;
    return MPI_SUCCESS;
}

/* Those whose coordinates in the other dimensions are the same. */
CALL(Cart_sub, (MPI_Comm comm, const int keep[], MPI_Comm *to))
{
    int code, color = 0, key = 0, dims = 0;
    const struct topology *t = topology_of("MPI_Cart_sub", comm, MPI_CART, &code);
    if (!t)
        return code;
    int coords[t->dims + 1], sides[t->dims + 1], periods[t->dims + 1];
    coords_of(t, comm_of(comm)->local->rank, coords);
    for (int d = 0; d < t->dims; d++) {
        if (keep[d]) {
            key = key * t->sides[d] + coords[d];
            sides[dims] = t->sides[d], periods[dims++] = t->periods[d];
        } else {
            color = color * t->sides[d] + coords[d];
        }
    }
    code = PMPI_Comm_split(comm, color, key, to);
    if (!code)
        comm_of(*to)->topology = grid_new(dims, sides, periods);
    return code;
}

/* --- graphs --- */

CALL(Graph_create, (MPI_Comm comm, int nodes, const int ends[], const int edges[], int reorder, MPI_Comm *to))
{
    struct coll o;
    int code = coll_begin(&o, CALL_Graph_create, comm);
    (void)reorder;
    if (code)
        return code;
    if (nodes < 0 || nodes > coll_size(&o))
        return fail(o.c, CALL_Graph_create, MPI_ERR_ARG, "the graph has %d nodes, the communicator %d ranks", nodes,
                    coll_size(&o));
    for (int i = 0; nodes && i < ends[nodes - 1]; i++)
        if (edges[i] < 0 || edges[i] >= nodes)
            return fail(o.c, CALL_Graph_create, MPI_ERR_ARG, "edge %d leads to %d, which is no node of the graph", i,
                        edges[i]);
    return make(&o, nodes, graph_new(nodes, ends, edges), to);
}

CALL(Graphdims_get, (MPI_Comm comm, int *nodes, int *edges))
{
    int code;
    const struct topology *t = topology_of("MPI_Graphdims_get", comm, MPI_GRAPH, &code);
    if (!t)
        return code;
    *nodes = t->nodes, *edges = t->edge_count;
    return MPI_SUCCESS;
}

CALL(Graph_get, (MPI_Comm comm, int most_nodes, int most_edges, int ends[], int edges[]))
{
    int code;
    const struct topology *t = topology_of("MPI_Graph_get", comm, MPI_GRAPH, &code);
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
    const struct topology *t = topology_of("MPI_Graph_neighbors_count", comm, MPI_GRAPH, &code);
    if (!t)
        return code;
    if (rank < 0 || rank >= t->nodes)
        return fail(comm_of(comm), CALL_Other, MPI_ERR_RANK, "MPI_Graph_neighbors_count: rank %d of %d", rank,
                    t->nodes);
    *count = t->ends[rank] - first_edge(t, rank);
    return MPI_SUCCESS;
}

CALL(Graph_neighbors, (MPI_Comm comm, int rank, int most, int neighbors[]))
{
    int code;
    const struct topology *t = topology_of("MPI_Graph_neighbors", comm, MPI_GRAPH, &code);
    if (!t)
        return code;
    if (rank < 0 || rank >= t->nodes)
        return fail(comm_of(comm), CALL_Other, MPI_ERR_RANK, "MPI_Graph_neighbors: rank %d of %d", rank, t->nodes);
    for (int i = first_edge(t, rank), n = 0; i < t->ends[rank] && n < most; i++, n++)
        neighbors[n] = t->edges[i];
    return MPI_SUCCESS;
}

CALL(Graph_map, (MPI_Comm comm, int nodes, const int ends[], const int edges[], int *rank))
{
    const struct comm *c = comm_of(comm);
    (void)ends, (void)edges;
    if (!c)
        return fail_comm(CALL_Other);
    *rank = c->local->rank < nodes ? c->local->rank : MPI_UNDEFINED;
    return MPI_SUCCESS;
}
