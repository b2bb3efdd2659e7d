/* topology_names.c - Fortran's names for grids and graphs. */
#include "fortran.h"

FORTRAN(dims_create, (f_int * nodes, f_int *dims, f_int *sides, f_int *ierr))
{
    IERR = MPI_Dims_create(*nodes, *dims, sides);
}

FORTRAN(cart_create,
        (f_int * comm, f_int *dims, f_int *sides, f_int *periods, f_int *reorder, f_int *to, f_int *ierr))
{
    NEW(MPI_Comm, to, MPI_Cart_create(F_COMM(comm), *dims, sides, periods, *reorder, &made));
}

FORTRAN(cart_coords, (f_int * comm, f_int *rank, f_int *most, f_int *coords, f_int *ierr))
{
    IERR = MPI_Cart_coords(F_COMM(comm), *rank, *most, coords);
}

FORTRAN(cart_rank, (f_int * comm, f_int *coords, f_int *rank, f_int *ierr))
{
    IERR = MPI_Cart_rank(F_COMM(comm), coords, rank);
}

FORTRAN(cart_shift, (f_int * comm, f_int *direction, f_int *by, f_int *source, f_int *dest, f_int *ierr))
{
    IERR = MPI_Cart_shift(F_COMM(comm), *direction, *by, source, dest);
}

FORTRAN(cart_sub, (f_int * comm, f_int *keep, f_int *to, f_int *ierr))
{
    NEW(MPI_Comm, to, MPI_Cart_sub(F_COMM(comm), keep, &made));
}

FORTRAN(cart_get, (f_int * comm, f_int *most, f_int *sides, f_int *periods, f_int *coords, f_int *ierr))
{
    IERR = MPI_Cart_get(F_COMM(comm), *most, sides, periods, coords);
}

FORTRAN(cart_map, (f_int * comm, f_int *dims, f_int *sides, f_int *periods, f_int *rank, f_int *ierr))
{
    IERR = MPI_Cart_map(F_COMM(comm), *dims, sides, periods, rank);
}

FORTRAN(graph_create,
        (f_int * comm, f_int *nodes, f_int *ends, f_int *edges, f_int *reorder, f_int *to, f_int *ierr))
{
    NEW(MPI_Comm, to, MPI_Graph_create(F_COMM(comm), *nodes, ends, edges, *reorder, &made));
}

FORTRAN(graph_get,
        (f_int * comm, f_int *most_nodes, f_int *most_edges, f_int *ends, f_int *edges, f_int *ierr))
{
    IERR = MPI_Graph_get(F_COMM(comm), *most_nodes, *most_edges, ends, edges);
}

FORTRAN(graphdims_get, (f_int * comm, f_int *nodes, f_int *edges, f_int *ierr))
{
    IERR = MPI_Graphdims_get(F_COMM(comm), nodes, edges);
}

FORTRAN(graph_neighbors_count, (f_int * comm, f_int *rank, f_int *count, f_int *ierr))
{
    IERR = MPI_Graph_neighbors_count(F_COMM(comm), *rank, count);
}

FORTRAN(graph_neighbors, (f_int * comm, f_int *rank, f_int *most, f_int *neighbors, f_int *ierr))
{
    IERR = MPI_Graph_neighbors(F_COMM(comm), *rank, *most, neighbors);
}

FORTRAN(graph_map, (f_int * comm, f_int *nodes, f_int *ends, f_int *edges, f_int *rank, f_int *ierr))
{
    IERR = MPI_Graph_map(F_COMM(comm), *nodes, ends, edges, rank);
}
