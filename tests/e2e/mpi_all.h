/* mpi_all.h - what the tests of MPI on simulated nodes share: their checks, each over all ranks. */
#ifndef MPI_ALL_H
#define MPI_ALL_H
#include <mpi.h>
#include <stdio.h>

static int rank, size;

/* Whether it holds on all ranks. */
static void all(const char *what, int holds)
{
    int everywhere;
    MPI_Allreduce(&holds, &everywhere, 1, MPI_INT, MPI_LAND, MPI_COMM_WORLD);
    if (rank == 0)
        printf("%s: %s\n", what, everywhere ? "yes" : "NO");
}
#endif
