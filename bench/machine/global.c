/* Operations of all nodes: gsync, gdsum of 1 and 1,000 elements, and messages to node -1, each against the
 * number of nodes. A broadcast's time is from the sender's call to the last receiver's return; the clocks of
 * simulated nodes agree.
 */
#include "bench.h"

enum { ROUNDS = 5, ELEMENTS = 1000, TYPE = 1, LARGEST = 65536 };

static double x[ELEMENTS], work[ELEMENTS];
static char buf[LARGEST];

/* Microseconds of an operation, from the last node's begin to the last node's end. */
static double sum_us(long elements)
{
    double total = 0;
    for (int i = 0; i < ROUNDS; i++) {
        double begin, end, w;
        gsync();
        begin = now_us();
        if (elements)
            gdsum(x, elements, work);
        else
            gsync();
        end = now_us();
        gdhigh(&begin, 1, &w);
        gdhigh(&end, 1, &w);
        total += end - begin;
    }
    return total / ROUNDS;
}

static double broadcast_us(long bytes, double *sender_us)
{
    double total = 0;
    *sender_us = 0;
    for (int i = 0; i < ROUNDS; i++) {
        double begin = 0, end, w;
        long id = mynode() ? irecv(TYPE, buf, bytes) : -1;
        gsync();
        if (mynode() == 0) {
            begin = now_us();
            csend(TYPE, buf, bytes, -1, 0);
            *sender_us += (now_us() - begin) / ROUNDS;
        } else {
            msgwait(id);
        }
        end = now_us();
        gdhigh(&end, 1, &w);
        total += end - begin;
    }
    return total / ROUNDS;
}

static void point(const char *series, double us)
{
    if (mynode() == 0)
        printf("point %s %ld %.3f\n", series, numnodes(), us);
}

int main(void)
{
    double sender;
    double gsync_us = sum_us(0);
    point("gsync", gsync_us);
    if (mynode() == 0)
        figure("gsync_per_dimension_us", gsync_us / nodedim());
    point("gdsum_1", sum_us(1));
    point("gdsum_1000", sum_us(ELEMENTS));
    point("broadcast_0", broadcast_us(0, &sender));
    point("broadcast_0_sender", sender);
    point("broadcast_1024", broadcast_us(1024, &sender));
    point("broadcast_65536", broadcast_us(LARGEST, &sender));
    point("broadcast_65536_sender", sender);
    return 0;
}
