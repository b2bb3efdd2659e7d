/* Messages between several pairs of nodes at a time, against the first pair alone.
 *
 *     contention NAME=FROM-TO,FROM-TO... ...
 *
 * All receives are posted before any node sends. The clocks of simulated nodes agree, so that the first begin
 * and the last end can be compared.
 */
#include <stdlib.h>
#include <string.h>
#include "bench.h"

enum { MESSAGES = 8, BYTES = 65536, TYPE = 10 };

static char in[MESSAGES][BYTES], out[BYTES];

/* All pairs of the list "0-3,1-7" at once; microseconds from the first send to the last arrival. */
static double together_us(const char *pairs)
{
    long to = -1, ids[MESSAGES], receives = 0;
    for (const char *p = pairs; p; p = strchr(p, ',') ? strchr(p, ',') + 1 : NULL) {
        if (atol(p) == mynode())
            to = atol(strchr(p, '-') + 1);
        receives += atol(strchr(p, '-') + 1) == mynode();
    }
    for (int i = 0; i < MESSAGES && receives; i++)
        ids[i] = irecv(TYPE, in[i], BYTES);
    gsync();
    double begin = to < 0 ? 1e30 : now_us(), end, work;
    for (int i = 0; i < MESSAGES && to >= 0; i++)
        csend(TYPE, out, BYTES, to, 0);
    for (int i = 0; i < MESSAGES && receives; i++)
        msgwait(ids[i]);
    end = receives ? now_us() : 0;
    gdlow(&begin, 1, &work);
    gdhigh(&end, 1, &work);
    return end - begin;
}

int main(int argc, char **argv)
{
    double alone = 0;
    for (int i = 1; i < argc; i++) {
        char *equals = strchr(argv[i], '=');
        double us = together_us(equals + 1);
        if (i == 1)
            alone = us;
        if (mynode() == 0)
            printf("figure %.*s %.6f\n", (int)(equals - argv[i]), argv[i], us / alone);
    }
    return 0;
}
