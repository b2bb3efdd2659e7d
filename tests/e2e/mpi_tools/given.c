/* given.c - calls of MPI that are given no buffer or list, by rank 1, or what is not for them. */
#include <mpi.h>
#include <string.h>

static void add(void *in, void *inout, int *count, MPI_Datatype *type)
{
    int *nowhere = NULL;
    (void)in, (void)inout, (void)count, (void)type;
    *nowhere = 1;
}

int main(int argc, char **argv)
{
    int rank, x = 1, parts[8] = {1, 1}, count;
    void *none = NULL;
    MPI_Op own;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (strcmp(argv[1], "gather") == 0)
        MPI_Gather(&x, 1, MPI_INT, none, 1, MPI_INT, 1, MPI_COMM_WORLD);
    if (strcmp(argv[1], "counts") == 0)
        MPI_Scatterv(parts, none, none, MPI_INT, &x, 1, MPI_INT, 1, MPI_COMM_WORLD);
    if (strcmp(argv[1], "place") == 0)
        MPI_Bcast(MPI_IN_PLACE, 1, MPI_INT, 1, MPI_COMM_WORLD);
    if (strcmp(argv[1], "status") == 0)
        MPI_Get_count(MPI_STATUS_IGNORE, MPI_INT, &count);
    if (strcmp(argv[1], "requests") == 0)
        MPI_Waitall(2, none, MPI_STATUSES_IGNORE);
    MPI_Op_create(add, 1, &own);
    MPI_Allreduce(&x, parts, 1, MPI_INT, own, MPI_COMM_WORLD);
    MPI_Finalize();
    return 0;
}
