/* type_arrays.c - datatypes for a part of an array: a block, or what a rank has of one that is shared out. */
#include <stdlib.h>
#include "types.h"

static void drop_inner(struct type *t)
{
    object_leave(&t->object);
    free(t->run);
    free(t);
}

static int check_array(int call, int dims, int order)
{
    if (dims > 0 && (order == MPI_ORDER_C || order == MPI_ORDER_FORTRAN))
        return MPI_SUCCESS;
    return fail(NULL, call, MPI_ERR_ARG, "%d dimensions, in order %d", dims, order);
}

/* A block of an array: from the dimension that varies fastest on, each makes a row of what is below it. */
CALL(Type_create_subarray, (int dims, const int sizes[], const int subsizes[], const int starts[], int order,
                            MPI_Datatype old, MPI_Datatype *type))
{
    const struct type *o = type_of(old);
    if (!o)
        return type_missing(CALL_Type_create_subarray);
    int code = check_array(CALL_Type_create_subarray, dims, order);
    if (code)
        return code;
    for (int d = 0; d < dims; d++)
        if (subsizes[d] < 1 || starts[d] < 0 || starts[d] > (long)sizes[d] - subsizes[d])
            return fail(NULL, CALL_Type_create_subarray, MPI_ERR_ARG,
                        "dimension %d has %d elements; %d from %d on are asked for", d, sizes[d], subsizes[d],
                        starts[d]);
    MPI_Aint step = type_extent(o), at = 0, whole = step;
    struct type *inner = NULL;
    for (int k = 0; k < dims; k++) {
        int d = order == MPI_ORDER_FORTRAN ? k : dims - 1 - k, room = 0;
        struct type *t = type_new();
        for (int i = 0; i < subsizes[d]; i++)
            type_add(t, &room, inner ? inner : o, 1, i * whole);
        at += starts[d] * whole;
        whole *= sizes[d];
        if (inner)
            drop_inner(inner);
        inner = t;
    }
    struct type *t = type_new();
    int room = 0;
    type_add(t, &room, inner, 1, at);
    drop_inner(inner);
    t->lb = 0, t->ub = whole, t->has_lb = t->has_ub = true;
    type_made_of(t, 2 + 3 * dims, 0, 1);
    t->int_list[0] = dims, t->int_list[1 + 3 * dims] = order;
    for (int d = 0; d < dims; d++) {
        t->int_list[1 + d] = sizes[d];
        t->int_list[1 + dims + d] = subsizes[d];
        t->int_list[1 + 2 * dims + d] = starts[d];
    }
    type_made_of_type(t, 0, old);
    *type = type_finish(t, MPI_COMBINER_SUBARRAY, false);
    return MPI_SUCCESS;
}

/* The elements of a dimension that a rank has: every so many blocks one of `block`. */
static struct type *distributed(const struct type *inner, MPI_Aint step, int size, int block, int parts,
                                int part)
{
    struct type *t = type_new();
    int room = 0;
    for (long first = (long)part * block; first < size; first += (long)parts * block)
        for (long i = first; i < first + block && i < size; i++)
            type_add(t, &room, inner, 1, i * step);
    return t;
}

/* Can the dimension of a distributed array be shared out? MPI_SUCCESS, or an error. */
static int check_distribution(int d, int size, int kind, int block, int parts)
{
    bool none = kind == MPI_DISTRIBUTE_NONE, whole = kind == MPI_DISTRIBUTE_BLOCK;
    bool known = none || whole || kind == MPI_DISTRIBUTE_CYCLIC;
    bool chosen = none || block == MPI_DISTRIBUTE_DFLT_DARG;
    if (known && size > 0 && parts > 0 && (!none || parts == 1) &&
        (chosen || (block > 0 && (!whole || (long)block * parts >= size))))
        return MPI_SUCCESS;
    return fail(NULL, CALL_Type_create_darray, MPI_ERR_ARG,
                "dimension %d: %d elements cannot be shared out in kind %d, by blocks of %d, among %d", d,
                size, kind, block, parts);
}

static int check_darray(int ranks, int rank, int dims, const int sizes[], const int kinds[],
                        const int blocks[], const int grid[])
{
    long parts = 1;
    for (int d = 0; d < dims; d++) {
        int code = check_distribution(d, sizes[d], kinds[d], blocks[d], grid[d]);
        if (code)
            return code;
        parts = parts > ranks ? parts : parts * grid[d];
    }
    if (parts == ranks && rank >= 0 && rank < ranks)
        return MPI_SUCCESS;
    return fail(NULL, CALL_Type_create_darray, MPI_ERR_ARG, "rank %d of %d, which the grid does not have",
                rank, ranks);
}

CALL(Type_create_darray,
     (int ranks, int rank, int dims, const int sizes[], const int kinds[], const int blocks[],
      const int grid[], int order, MPI_Datatype old, MPI_Datatype *type))
{
    const struct type *o = type_of(old);
    if (!o)
        return type_missing(CALL_Type_create_darray);
    int code = check_array(CALL_Type_create_darray, dims, order);
    code = code ? code : check_darray(ranks, rank, dims, sizes, kinds, blocks, grid);
    if (code)
        return code;
    MPI_Aint step = type_extent(o);
    struct type *inner = NULL;
    int coords[dims + 1], left = rank, room = 0;
    for (int d = dims - 1; d >= 0; d--) {
        coords[d] = left % grid[d];
        left /= grid[d];
    }
    for (int k = 0; k < dims; k++) {
        int d = order == MPI_ORDER_FORTRAN ? k : dims - 1 - k, block = blocks[d];
        if (kinds[d] == MPI_DISTRIBUTE_NONE)
            block = sizes[d];
        else if (block == MPI_DISTRIBUTE_DFLT_DARG)
            block = kinds[d] == MPI_DISTRIBUTE_BLOCK ? (sizes[d] + grid[d] - 1) / grid[d] : 1;
        struct type *t = distributed(inner ? inner : o, step, sizes[d], block,
                                     kinds[d] == MPI_DISTRIBUTE_NONE ? 1 : grid[d],
                                     kinds[d] == MPI_DISTRIBUTE_NONE ? 0 : coords[d]);
        if (inner)
            drop_inner(inner);
        inner = t;
        step *= sizes[d];
    }
    struct type *t = type_new();
    type_add(t, &room, inner, 1, 0);
    drop_inner(inner);
    t->lb = 0, t->ub = step, t->has_lb = t->has_ub = true;
    type_made_of(t, 4 + 4 * dims, 0, 1);
    t->int_list[0] = ranks, t->int_list[1] = rank, t->int_list[2] = dims, t->int_list[3 + 4 * dims] = order;
    for (int d = 0; d < dims; d++) {
        const int *lists[] = {sizes, kinds, blocks, grid};
        for (int i = 0; i < 4; i++)
            t->int_list[3 + i * dims + d] = lists[i][d];
    }
    type_made_of_type(t, 0, old);
    *type = type_finish(t, MPI_COMBINER_DARRAY, false);
    return MPI_SUCCESS;
}
