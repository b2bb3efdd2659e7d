/* traffic_mpi.c - traffic_mpi PATTERN ROUNDS: the patterns of traffic/traffic.c with MPI's calls, and
 *
 *   allreduce  every rank: MPI_Allreduce of 8 bytes
 *   alltoall   every rank: MPI_Alltoall, with 8 bytes for each rank, up to 1,024 ranks
 *
 * It is for touchstone and for other simulators of MPI. */
#include <mpi.h>
#include <stdbool.h>
#include <stdio.h>
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

static void allreduce(void)
{
    static double own = 1, sum;
    MPI_Allreduce(&own, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

static void alltoall(void)
{
    static char parts[2][1024][BYTES];
    MPI_Alltoall(parts[0], BYTES, MPI_BYTE, parts[1], BYTES, MPI_BYTE, MPI_COMM_WORLD);
}

static void none(void) {}

static void (*pattern_named(const char *name))(void)
{
    static const struct {
        const char *name;
        void (*round)(void);
    } patterns[] = {{"none", none}, {"pingpong", pingpong},   {"ring", ring},
                    {"halo", halo}, {"allreduce", allreduce}, {"alltoall", alltoall}};
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++)
        if (!strcmp(name, patterns[i].name))
            return patterns[i].round;
    return NULL;
}

int main(int argc, char **argv)
{
    void (*round)(void) = argc > 2 ? pattern_named(argv[1]) : NULL;
    if (!round) {
        fprintf(stderr, "usage: traffic_mpi none|pingpong|ring|halo|allreduce|alltoall ROUNDS\n");
        return 64;
    }
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &me);
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    for (long i = 0, rounds = atol(argv[2]); i < rounds; i++)
        round();
    MPI_Finalize();
    return 0;
}
