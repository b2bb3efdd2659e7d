/* traffic.c - the patterns of messages whose simulation is timed: traffic PATTERN ROUNDS, as an NX program.
 * peers/traffic_mpi.c does the same with MPI's calls, and with the same buffers. A round is
 *
 *   none       nothing: the program starts and ends
 *   pingpong   nodes 0 and 1: one message there, one back
 *   ring       every node: a message to the next, one from the one before
 *   halo       every node of a torus as square as can be: a message to each of four neighbours, four received
 *   alltoall   every node: a message to each other node, in the order of the distance
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx.h"
#include "torus.h"

enum { BYTES = 8 };
static char out[BYTES], in[4][BYTES];
static long me, count;

static void pingpong(void)
{
    if (me == 0)
        csend(1, out, BYTES, 1, 0);
    if (me < 2)
        crecv(1, in[0], BYTES);
    if (me == 1)
        csend(1, out, BYTES, 0, 0);
}

static void ring(void)
{
    csend(1, out, BYTES, (me + 1) % count, 0);
    crecv(1, in[0], BYTES);
}

static void halo(void)
{
    static bool begun;
    static long to[4];
    long id[4], k;
    if (!begun)
        torus_neighbours(me, count, to);
    begun = true;
    for (k = 0; k < 4; k++)
        id[k] = irecv(k, in[k], BYTES);
    for (k = 0; k < 4; k++)
        csend(k, out, BYTES, to[k], 0);
    for (k = 0; k < 4; k++)
        msgwait(id[k]);
}

static void alltoall(void)
{
    long k;
    for (k = 1; k < count; k++)
        csend(1, out, BYTES, (me + k) % count, 0);
    for (k = 1; k < count; k++)
        crecv(1, in[0], BYTES);
}

static void none(void) {}

static void (*pattern_named(const char *name))(void)
{
    static const struct {
        const char *name;
        void (*round)(void);
    } patterns[] = {
        {"none", none}, {"pingpong", pingpong}, {"ring", ring}, {"halo", halo}, {"alltoall", alltoall}};
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++)
        if (!strcmp(name, patterns[i].name))
            return patterns[i].round;
    return NULL;
}

int main(int argc, char **argv)
{
    void (*round)(void) = argc > 2 ? pattern_named(argv[1]) : NULL;
    long rounds = argc > 2 ? atol(argv[2]) : 0;
    if (!round) {
        fprintf(stderr, "usage: traffic none|pingpong|ring|halo|alltoall ROUNDS\n");
        return 64;
    }
    me = mynode(), count = numnodes();
    for (long i = 0; i < rounds; i++)
        round();
    return 0;
}
