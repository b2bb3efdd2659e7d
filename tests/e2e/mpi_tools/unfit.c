/* unfit.c - collectives whose members do not fit together, as the argument says. */
#include <mpi.h>
#include <string.h>

static void sends(int *y, int count)
{
    MPI_Bcast(y, count, MPI_INT, 0, MPI_COMM_WORLD);
}

int main(int argc, char **argv)
{
    int rank, x = 1, y[8];
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const char *how = argv[1];
    if (strcmp(how, "root") == 0)
        MPI_Bcast(&x, 1, MPI_INT, rank == 1, MPI_COMM_WORLD);
    if (strcmp(how, "stuck") == 0) {
        MPI_Bcast(&x, 1, MPI_INT, rank == 3, MPI_COMM_WORLD);
        MPI_Barrier(MPI_COMM_WORLD);
    }
    if (strcmp(how, "op") == 0)
        MPI_Allreduce(&x, y, 1, MPI_INT, rank == 1 ? MPI_MAX : MPI_SUM, MPI_COMM_WORLD);
    if (strcmp(how, "count") == 0)
        MPI_Bcast(y, rank == 1 ? 8 : 4, MPI_INT, 0, MPI_COMM_WORLD);
    if (strcmp(how, "caller") == 0) {
        if (rank == 1)
            sends(y, 8);
        else
            sends(y, 4);
    }
    if (strcmp(how, "type") == 0)
        MPI_Bcast(y, 1, rank == 1 ? MPI_FLOAT : MPI_INT, 0, MPI_COMM_WORLD);
    if (strcmp(how, "call") == 0) {
        if (rank == 1)
            MPI_Barrier(MPI_COMM_WORLD);
        else
            MPI_Bcast(&x, 1, MPI_INT, 0, MPI_COMM_WORLD);
    }
    if (strncmp(how, "part", 4) == 0) { /* "parts": of a split communicator, which fit well */
        MPI_Comm part;
        MPI_Comm_split(MPI_COMM_WORLD, rank % 2, rank, &part);
        MPI_Bcast(y, rank % 2 || (rank == 2 && strcmp(how, "part") == 0) ? 8 : 4, MPI_INT, 0, part);
        if (rank % 2)
            MPI_Barrier(part);
        else
            MPI_Allreduce(&x, y, 1, MPI_INT, MPI_SUM, part);
        MPI_Comm_free(&part);
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
