/* signatures.c - rank 0 sends to rank 1, which receives as other kinds of numbers of the same length, or,
 * with the argument "well", as the same kinds by other datatypes. */
#include <mpi.h>
#include <stddef.h>
#include <string.h>

static int rank;
static double room[64];

static void move(int count, MPI_Datatype type, int most, MPI_Datatype as)
{
    if (rank == 0)
        MPI_Send(room, count, type, 1, 1, MPI_COMM_WORLD);
    else if (rank == 1)
        MPI_Recv(room, most, as, 0, 1, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}

/* An int, doubles and floats: as they lie in C, or one behind the other. */
static MPI_Datatype mixed(int doubles, int floats)
{
    int lengths[3] = {1, doubles, floats};
    MPI_Aint at[3] = {0, 8, 8 + 8 * doubles};
    MPI_Datatype types[3] = {MPI_INT, MPI_DOUBLE, MPI_FLOAT}, made;
    MPI_Type_create_struct(3, lengths, at, types, &made);
    MPI_Type_commit(&made);
    return made;
}

static void start(MPI_Datatype type, int most, MPI_Datatype as)
{
    MPI_Request requests[2];
    if (rank == 0)
        MPI_Send_init(room, 1, type, 1, 1, MPI_COMM_WORLD, &requests[0]);
    else
        MPI_Recv_init(room, most, as, 0, 1, MPI_COMM_WORLD, &requests[0]);
    MPI_Send_init(room, 1, MPI_INT, MPI_PROC_NULL, 1, MPI_COMM_WORLD, &requests[1]);
    MPI_Startall(2, requests);
    MPI_Waitall(2, requests, MPI_STATUSES_IGNORE);
    for (int i = 0; i < 2; i++)
        MPI_Request_free(&requests[i]);
}

static void well(void)
{
    MPI_Datatype a = mixed(2, 0), b = mixed(1, 1), apart, many, text, precise, nothing;
    int places[3] = {4, 0, 2};
    double packed[8];
    MPI_Type_indexed(3, (int[]){1, 2, 1}, places, MPI_DOUBLE, &apart);
    MPI_Type_commit(&apart);
    MPI_Type_vector(2, 1, 2, b, &many);
    MPI_Type_commit(&many);
    MPI_Type_create_subarray(1, (int[]){9}, (int[]){4}, (int[]){2}, MPI_ORDER_C, MPI_CHAR, &text);
    MPI_Type_commit(&text);
    MPI_Type_create_f90_real(15, 307, &precise);
    MPI_Type_contiguous(0, a, &nothing);
    MPI_Type_commit(&nothing);
    move(1, apart, 7, MPI_DOUBLE);
    move(2, b, 2, many);
    move(1, many, 5, b);
    move(1, MPI_DOUBLE_INT, 1, MPI_DOUBLE_INT);
    move(2, MPI_2INT, 4, MPI_INT);
    move(2, text, 8, MPI_SIGNED_CHAR);
    move(3, precise, 3, MPI_DOUBLE_PRECISION);
    move(8, MPI_BYTE, 8, MPI_BYTE);
    move(0, MPI_INT, 8, MPI_DOUBLE);
    move(1, nothing, 8, MPI_DOUBLE);
    start(MPI_DOUBLE, 2, MPI_DOUBLE);
    if (rank == 0) {
        int length = 0;
        MPI_Pack(room, 1, a, packed, sizeof packed, &length, MPI_COMM_WORLD);
        MPI_Send(packed, length, MPI_PACKED, 1, 1, MPI_COMM_WORLD);
    } else {
        MPI_Recv(room, 1, a, 0, 1, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    }
    move(1, a, sizeof room, MPI_PACKED);
    MPI_Bcast(room, rank ? 1 : 4, rank ? apart : MPI_DOUBLE, 0, MPI_COMM_WORLD);
    MPI_Type_free(&apart);
    MPI_Type_free(&many);
    MPI_Type_free(&text);
    MPI_Type_free(&nothing);
    MPI_Type_free(&a);
    MPI_Type_free(&b);
}

int main(int argc, char **argv)
{
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Datatype a = mixed(2, 0), b = mixed(1, 2);
    const char *how = argv[1];
    if (strcmp(how, "halves") == 0)
        move(1, MPI_DOUBLE, 2, MPI_FLOAT);
    if (strcmp(how, "behind") == 0)
        move(2, a, 3, b);
    if (strcmp(how, "bytes") == 0)
        move(2, MPI_INT, 8, MPI_BYTE);
    if (strcmp(how, "start") == 0)
        start(MPI_DOUBLE, 2, MPI_FLOAT);
    if (strcmp(how, "all") == 0)
        MPI_Bcast(room, rank ? 2 : 1, rank ? MPI_FLOAT : MPI_DOUBLE, 0, MPI_COMM_WORLD);
    MPI_Type_free(&a);
    MPI_Type_free(&b);
    if (strcmp(how, "well") == 0)
        well();
    MPI_Finalize();
    return 0;
}
