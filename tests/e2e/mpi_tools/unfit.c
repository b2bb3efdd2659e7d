/* unfit.c - collectives whose members do not fit together, as the argument says. */
#include <mpi.h>
#include <string.h>

int main(int argc, char **argv)
{
    int rank, x = 1, y[8];
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const char *how = argv[1];
    if (strcmp(how, "root") == 0)
        MPI_Bcast(&x, 1, MPI_INT, rank == 1, MPI_COMM_WORLD);
    if (strcmp(how, "op") == 0)
        MPI_Allreduce(&x, y, 1, MPI_INT, rank == 1 ? MPI_MAX : MPI_SUM, MPI_COMM_WORLD);
    if (strcmp(how, "count") == 0)
        MPI_Bcast(y, rank == 1 ? 8 : 4, MPI_INT, 0, MPI_COMM_WORLD);
    if (strcmp(how, "type") == 0)
        MPI_Bcast(y, 1, rank == 1 ? MPI_FLOAT : MPI_INT, 0, MPI_COMM_WORLD);
    if (strcmp(how, "call") == 0) {
        if (rank == 1)
            MPI_Barrier(MPI_COMM_WORLD);
        else
            MPI_Bcast(&x, 1, MPI_INT, 0, MPI_COMM_WORLD);
    }
    if (strcmp(how, "wait") == 0 && rank == 1)
        MPI_Recv(&x, 1, MPI_INT, 0, 5, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (strcmp(how, "tag") == 0 && rank == 0)
        MPI_Send(&x, 1, MPI_INT, 1, 5, MPI_COMM_WORLD);
    if (strcmp(how, "tag") == 0 && rank == 1)
        MPI_Recv(&x, 1, MPI_INT, 0, 6, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (strcmp(how, "end") == 0 && rank == 0)
        return 0;
    MPI_Finalize();
    return 0;
}
