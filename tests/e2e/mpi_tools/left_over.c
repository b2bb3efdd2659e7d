/* left_over.c - leaves something over of each kind, but with the argument "well"; receives reals as integers.
 * With "ends" it ends without MPI_Finalize; with "callers" it leaves communicators that a function of its own
 * makes for two callers. With "attributes" it keeps communicators as attributes, whose functions duplicate and
 * free them, one of them in MPI_Finalize; with "attributes kept" they free none. */
#include <mpi.h>

static __attribute__((noinline)) void duplicate(MPI_Comm *to)
{
    MPI_Comm_dup(MPI_COMM_WORLD, to);
}

static int keep;

static int copy(MPI_Comm comm, int key, void *extra, void *value, void *to, int *flag)
{
    static MPI_Comm copied;
    (void)comm, (void)key, (void)extra;
    *(MPI_Comm **)to = &copied;
    *flag = 1;
    return MPI_Comm_dup(*(MPI_Comm *)value, &copied);
}

static int release(MPI_Comm comm, int key, void *value, void *extra)
{
    (void)comm, (void)key, (void)extra;
    return keep ? MPI_SUCCESS : MPI_Comm_free(value);
}

static void attributes(void)
{
    static MPI_Comm one, two;
    MPI_Comm world;
    int key;
    MPI_Comm_create_keyval(copy, release, &key, NULL);
    MPI_Comm_dup(MPI_COMM_WORLD, &one);
    MPI_Comm_split(MPI_COMM_WORLD, 0, 0, &two);
    MPI_Comm_set_attr(MPI_COMM_WORLD, key, &one);
    MPI_Comm_set_attr(MPI_COMM_SELF, key, &two);
    MPI_Comm_dup(MPI_COMM_WORLD, &world);
    MPI_Comm_free(&world);
    MPI_Comm_delete_attr(MPI_COMM_WORLD, key);
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
    if (argc > 1 && argv[1][0] == 'a') {
        keep = argc > 2;
        attributes();
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
