/* left_over.c - leaves something over of each kind, but with the argument "well"; receives reals as integers.
 * With "ends" it ends without MPI_Finalize; with "callers" it leaves communicators that a function of its own
 * makes for two callers. */
#include <mpi.h>

static __attribute__((noinline)) void duplicate(MPI_Comm *to)
{
    MPI_Comm_dup(MPI_COMM_WORLD, to);
}

int main(int argc, char **argv)
{
    int rank, size, in, got, out = 1;
    MPI_Comm dup;
    MPI_Datatype pair;
    MPI_Group group;
    MPI_Request pending, kept;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    int right = (rank + 1) % size, left = (rank + size - 1) % size;
    if (argc > 1 && argv[1][0] == 'c') {
        duplicate(&dup);
        duplicate(&dup);
        MPI_Finalize();
        return 0;
    }
    MPI_Comm_dup(MPI_COMM_WORLD, &dup);
    if (argc > 1 && argv[1][0] == 'e')
        return 0;
    MPI_Comm_group(dup, &group);
    MPI_Type_contiguous(2, MPI_INT, &pair);
    MPI_Type_commit(&pair);
    MPI_Irecv(&in, 1, MPI_INT, left, 9, dup, &pending);
    MPI_Send_init(&out, 1, MPI_INT, right, 9, dup, &kept);
    MPI_Send(&out, 1, MPI_INT, right, 5, dup);
    if (argc > 1) {
        MPI_Start(&kept);
        MPI_Wait(&kept, MPI_STATUS_IGNORE);
        MPI_Wait(&pending, MPI_STATUS_IGNORE);
        MPI_Recv(&got, 1, MPI_INT, left, 5, dup, MPI_STATUS_IGNORE);
        MPI_Request_free(&kept);
        MPI_Type_free(&pair);
        MPI_Group_free(&group);
        MPI_Comm_free(&dup);
    } else {
        float f = 1;
        MPI_Sendrecv(&f, 1, MPI_FLOAT, right, 6, &got, 1, MPI_INT, left, 6, MPI_COMM_WORLD,
                     MPI_STATUS_IGNORE);
    }
    MPI_Finalize();
    return 0;
}
