/* freed_early.c - an operation and a datatype that are freed while collectives use them, as MPI allows. */
#include <mpi.h>
#include <stdio.h>

static void add(void *in, void *inout, int *count, MPI_Datatype *type)
{
    (void)type;
    for (int i = 0; i < *count * 2; i += 2)
        ((int *)inout)[i] += ((int *)in)[i];
}

int main(int argc, char **argv)
{
    int rank, size, x[4], sums[4] = {0}, right = 1;
    MPI_Op op;
    MPI_Datatype every_second;
    MPI_Request r, p;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    for (int i = 0; i < 4; i++)
        x[i] = rank + 1;
    MPI_Op_create(add, 1, &op);
    MPI_Type_create_resized(MPI_INT, 0, 2 * sizeof(int), &every_second);
    MPI_Type_commit(&every_second);
    MPI_Allreduce_init(x, sums, 2, every_second, op, MPI_COMM_WORLD, MPI_INFO_NULL, &p);
    MPI_Iallreduce(x, sums, 2, every_second, op, MPI_COMM_WORLD, &r);
    MPI_Op_free(&op);
    MPI_Type_free(&every_second);
    for (int i = 0; i < 2; i++) {
        MPI_Wait(i ? &p : &r, MPI_STATUS_IGNORE);
        right &= sums[0] == size * (size + 1) / 2 && sums[1] == 0 && sums[2] == sums[0] && sums[3] == 0;
        sums[0] = sums[2] = 0;
        if (!i)
            MPI_Start(&p);
    }
    MPI_Request_free(&p);
    if (rank == 0)
        puts(right ? "right" : "wrong");
    MPI_Finalize();
    return 0;
}
