/* under_way.c - buffers that are touched while MPI's calls have them: one of each kind. With an argument,
 * none. */
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

static int early; /* touches before the requests are done */

static void waits(MPI_Request *r, int count)
{
    MPI_Waitall(count, r, MPI_STATUSES_IGNORE);
}

int main(int argc, char **argv)
{
    int rank, size, out = 1, in = 0, kept = 2, sum = 0;
    double *grid = calloc(100, sizeof *grid);
    MPI_Request r[2], p;
    MPI_Datatype column;
    early = argc < 2;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    int left = (rank + size - 1) % size, right = (rank + 1) % size;

    MPI_Irecv(&in, 1, MPI_INT, left, 3, MPI_COMM_WORLD, &r[0]);
    MPI_Isend(&out, 1, MPI_INT, right, 3, MPI_COMM_WORLD, &r[1]);
    if (early)
        out = in;
    waits(r, 2);

    MPI_Type_vector(10, 1, 10, MPI_DOUBLE, &column);
    MPI_Type_commit(&column);
    MPI_Irecv(&grid[0], 1, column, left, 4, MPI_COMM_WORLD, &r[0]);
    MPI_Isend(&grid[9], 1, column, right, 4, MPI_COMM_WORLD, &r[1]);
    grid[11] = 5; /* between the pieces */
    if (early)
        grid[19] = 2;
    waits(r, 2);

    MPI_Iallreduce(&kept, &sum, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD, &r[0]);
    if (early)
        kept = 3;
    waits(r, 1);
    kept = 4;

    int ends[2] = {0, 0}, ring = 1, sides[1] = {0}, period[1] = {1};
    MPI_Comm grid_comm, half, two;
    MPI_Dims_create(size, 1, sides);
    MPI_Cart_create(MPI_COMM_WORLD, 1, sides, period, 0, &grid_comm);
    MPI_Ineighbor_allgather(&ring, 1, MPI_INT, ends, 1, MPI_INT, grid_comm, &r[0]);
    if (early)
        ends[1] = 1;
    waits(r, 1);

    int all[2] = {0, 0}, root = rank == 0 ? MPI_ROOT : rank % 2 ? 0 : MPI_PROC_NULL;
    MPI_Comm_split(MPI_COMM_WORLD, rank % 2, rank, &half);
    MPI_Intercomm_create(half, 0, MPI_COMM_WORLD, 1 - rank % 2, 9, &two);
    MPI_Igather(&ring, 1, MPI_INT, all, 1, MPI_INT, root, two, &r[0]);
    if (early && rank == 0)
        all[1] = 1;
    else if (rank == 2)
        all[1] = 1; /* beside the root */
    waits(r, 1);
    MPI_Comm_free(&two);
    MPI_Comm_free(&half);
    MPI_Comm_free(&grid_comm);

    MPI_Send_init(&kept, 1, MPI_INT, right, 5, MPI_COMM_WORLD, &p);
    kept = 5;
    for (int i = 0; i < 2; i++) {
        MPI_Start(&p);
        MPI_Recv(&in, 1, MPI_INT, left, 5, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        if (early)
            kept = 6;
        waits(&p, 1);
        kept = 7;
    }
    MPI_Request_free(&p);
    MPI_Type_free(&column);
    if (rank == 0)
        printf("%d %d %g\n", in, sum, grid[10]);
    free(grid);
    MPI_Finalize();
    return 0;
}
