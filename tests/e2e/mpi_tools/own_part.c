/* own_part.c - programs of MPI-1 hand a gather its own part where it is to lie. Buffers that overlap otherwise,
 * by the arguments "pair" and "whole"; "well": none do. */
#include <mpi.h>
#include <stdio.h>
#include <string.h>

enum { MOST = 64 };
static int rank, size, all[MOST], ones[MOST], places[MOST];

static void own_parts(void)
{
    MPI_Request request;
    all[rank] = rank + 1;
    MPI_Allgather(&all[rank], 1, MPI_INT, all, 1, MPI_INT, MPI_COMM_WORLD);
    all[rank] *= 2;
    MPI_Iallgather(&all[rank], 1, MPI_INT, all, 1, MPI_INT, MPI_COMM_WORLD, &request);
    MPI_Wait(&request, MPI_STATUS_IGNORE);
    all[rank] *= 2;
    MPI_Allgatherv(&all[rank], 1, MPI_INT, all, ones, places, MPI_INT, MPI_COMM_WORLD);
    all[rank] *= 2;
    MPI_Gather(&all[rank], 1, MPI_INT, all, 1, MPI_INT, 0, MPI_COMM_WORLD);
    for (int i = 0; rank == 0 && i < size; i++)
        all[i] *= 2;
    MPI_Scatter(all, 1, MPI_INT, &all[rank], 1, MPI_INT, 0, MPI_COMM_WORLD);
    printf("rank %d has %d\n", rank, all[rank]);
}

static void pair(void)
{
    MPI_Sendrecv(all, 2, MPI_INT, rank ^ 1, 1, all + 1, 2, MPI_INT, rank ^ 1, 1, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
}

/* One column of a matrix goes, another comes: their pieces lie between each other. */
static void well(void)
{
    MPI_Datatype column;
    MPI_Type_vector(4, 1, 4, MPI_INT, &column);
    MPI_Type_commit(&column);
    MPI_Sendrecv(all, 1, column, rank ^ 1, 1, all + 1, 1, column, rank ^ 1, 1, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
    MPI_Sendrecv_replace(all, 1, column, rank ^ 1, 1, rank ^ 1, 1, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    MPI_Allgather(MPI_IN_PLACE, 0, MPI_INT, all, 1, MPI_INT, MPI_COMM_WORLD);
    MPI_Bcast(all, 1, MPI_INT, 0, MPI_COMM_WORLD);
    MPI_Gather(all, 1, MPI_INT, rank ? all : all + 1, 1, MPI_INT, 0, MPI_COMM_WORLD);
    MPI_Allreduce(all, all + 1, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    MPI_Type_free(&column);
}

int main(int argc, char **argv)
{
    const char *how = argc > 1 ? argv[1] : "";
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    for (int i = 0; i < size; i++)
        ones[i] = 1, places[i] = i;
    if (strcmp(how, "pair") == 0)
        pair();
    else if (strcmp(how, "whole") == 0)
        MPI_Allgather(all, 1, MPI_INT, all, 1, MPI_INT, MPI_COMM_WORLD);
    else if (strcmp(how, "well") == 0)
        well();
    else
        own_parts();
    MPI_Finalize();
    return 0;
}
