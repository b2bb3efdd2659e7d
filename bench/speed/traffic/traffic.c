/* traffic.c - the patterns of messages whose simulation is timed: traffic PATTERN ROUNDS [BYTES], as an NX program.
 * peers/traffic_mpi.c does the same with MPI's calls. A round is
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

enum { MOST = 4096 };
static char out[MOST], in[4][MOST];
static long me, count, bytes = 8;

static void pingpong(void)
{
    if (me == 0)
        csend(1, out, bytes, 1, 0);
    if (me < 2)
        crecv(1, in[0], bytes);
    if (me == 1)
        csend(1, out, bytes, 0, 0);
}

static void ring(void)
{
    csend(1, out, bytes, (me + 1) % count, 0);
    crecv(1, in[0], bytes);
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
        id[k] = irecv(k, in[k], bytes);
    for (k = 0; k < 4; k++)
        csend(k, out, bytes, to[k], 0);
    for (k = 0; k < 4; k++)
        msgwait(id[k]);
}

static void alltoall(void)
{
    long k;
    for (k = 1; k < count; k++)
        csend(1, out, bytes, (me + k) % count, 0);
    for (k = 1; k < count; k++)
        crecv(1, in[0], bytes);
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
    if (argc > 3)
        bytes = atol(argv[3]);
    if (!round || bytes < 0 || bytes > MOST) {
        fprintf(stderr, "usage: traffic none|pingpong|ring|halo|alltoall ROUNDS [BYTES, at most %d]\n", MOST);
        return 64;
    }
    me = mynode(), count = numnodes();
    for (long i = 0; i < rounds; i++)
        round();
    return 0;
}
