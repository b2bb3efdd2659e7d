/* too_small.c - buffers that are smaller than a call has been told. */
#include <mpi.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char **argv)
{
    double *a, *b;
    int rank, size;
    MPI_Datatype column;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    a = calloc(100, sizeof *a);
    b = calloc(100, sizeof *b);
    MPI_Type_vector(11, 1, 10, MPI_DOUBLE, &column);
    MPI_Type_commit(&column);
    if (strcmp(argv[1], "column") == 0)
        MPI_Bcast(a, 1, column, 0, MPI_COMM_WORLD);
    if (strcmp(argv[1], "reduce") == 0)
        MPI_Allreduce(a, b, 101, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    if (strcmp(argv[1], "gather") == 0)
        MPI_Gather(a, 60, MPI_DOUBLE, b, 60, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    MPI_Type_free(&column);
    free(a);
    free(b);
    MPI_Finalize();
    return 0;
}
