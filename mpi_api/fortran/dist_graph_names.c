/* dist_graph_names.c - Fortran's names for the calls on distributed graphs. */
#include "fortran.h"

static int *weights(f_int *w)
{
    return w == &mpi_fortran_unweighted_      ? MPI_UNWEIGHTED
           : w == &mpi_fortran_weights_empty_ ? MPI_WEIGHTS_EMPTY
                                              : w;
}

FORTRAN(dist_graph_create_adjacent,
        (f_int * comm, f_int *ins, f_int *sources, f_int *in_weights, f_int *outs, f_int *dests,
         f_int *out_weights, f_int *info, f_int *reorder, f_int *to, f_int *ierr))
{
    NEW(MPI_Comm, to,
        MPI_Dist_graph_create_adjacent(F_COMM(comm), *ins, sources, weights(in_weights), *outs, dests,
                                       weights(out_weights), F_HANDLE(MPI_Info, *info), *reorder, &made));
}

FORTRAN(dist_graph_create, (f_int * comm, f_int *count, f_int *sources, f_int *degrees, f_int *dests,
                            f_int *of_edges, f_int *info, f_int *reorder, f_int *to, f_int *ierr))
{
    NEW(MPI_Comm, to,
        MPI_Dist_graph_create(F_COMM(comm), *count, sources, degrees, dests, weights(of_edges),
                              F_HANDLE(MPI_Info, *info), *reorder, &made));
}

FORTRAN(dist_graph_neighbors_count, (f_int * comm, f_int *ins, f_int *outs, f_int *weighted, f_int *ierr))
{
    IERR = MPI_Dist_graph_neighbors_count(F_COMM(comm), ins, outs, weighted);
}

FORTRAN(dist_graph_neighbors, (f_int * comm, f_int *most_ins, f_int *sources, f_int *in_weights,
                               f_int *most_outs, f_int *dests, f_int *out_weights, f_int *ierr))
{
    IERR = MPI_Dist_graph_neighbors(F_COMM(comm), *most_ins, sources, weights(in_weights), *most_outs, dests,
                                    weights(out_weights));
}
