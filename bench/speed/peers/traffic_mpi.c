/* traffic_mpi.c - traffic_mpi PATTERN ROUNDS: the patterns of traffic/traffic.c with MPI's calls, for
 * simulators of MPI. */
#include <mpi.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "../traffic/torus.h"

enum { BYTES = 8 };
static char out[BYTES], in[4][BYTES];
static int me, count;

static void pingpong(void)
{
    if (me == 0)
        MPI_Send(out, BYTES, MPI_BYTE, 1, 1, MPI_COMM_WORLD);
    if (me < 2)
        MPI_Recv(in[0], BYTES, MPI_BYTE, 1 - me, 1, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (me == 1)
        MPI_Send(out, BYTES, MPI_BYTE, 0, 1, MPI_COMM_WORLD);
}

static void ring(void)
{
    MPI_Send(out, BYTES, MPI_BYTE, (me + 1) % count, 1, MPI_COMM_WORLD);
    MPI_Recv(in[0], BYTES, MPI_BYTE, (me + count - 1) % count, 1, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}

static void halo(void)
{
    static bool begun;
    static long to[4];
    MPI_Request request[4];
    if (!begun)
        torus_neighbours(me, count, to);
    begun = true;
    for (int k = 0; k < 4; k++)
        MPI_Irecv(in[k], BYTES, MPI_BYTE, (int)to[k ^ 1], k, MPI_COMM_WORLD, &request[k]);
    for (int k = 0; k < 4; k++)
        MPI_Send(out, BYTES, MPI_BYTE, (int)to[k], k, MPI_COMM_WORLD);
    MPI_Waitall(4, request, MPI_STATUSES_IGNORE);
}

int main(int argc, char **argv)
{
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &me);
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    for (long i = 0, rounds = argc > 2 ? atol(argv[2]) : 0; i < rounds; i++)
        if (!strcmp(argv[1], "pingpong"))
            pingpong();
        else if (!strcmp(argv[1], "ring"))
            ring();
        else if (!strcmp(argv[1], "halo"))
            halo();
    MPI_Finalize();
    return 0;
}
