/* pingpong.c - two nodes exchange messages for so many rounds, in all the ways in which messages come: a
 * receive that waits, one that was posted, a handler; and take and give back memory. Node 0 prints the
 * days that have passed. */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>

enum { TO, FRO, CALL, EACH_CALL = 100, BYTES = 1000 };
static char out[BYTES], in[BYTES], called[BYTES];
static long calls;

static void on_call(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    calls++;
}

static void exchange(long me, long round)
{
    long posted = round % 2 ? irecv(me ? TO : FRO, in, sizeof in) : -1;

    if (me == 0)
        csend(TO, out, sizeof out, 1, 0);
    if (posted >= 0)
        msgwait(posted);
    else
        crecv(me ? TO : FRO, in, sizeof in);
    if (me == 1)
        csend(FRO, out, sizeof out, 0, 0);
}

/* Each node is interrupted by the other. */
static void call(long me)
{
    char *block = malloc(BYTES + (size_t)(calls % BYTES));

    hrecv(CALL, called, sizeof called, on_call);
    gsync();
    csend(CALL, out, sizeof out, 1 - me, 0);
    gsync();
    free(block);
}

int main(int argc, char **argv)
{
    long rounds = argc > 1 ? atol(argv[1]) : EACH_CALL;

    for (long round = 0; round < rounds; round++) {
        exchange(mynode(), round);
        if (round % EACH_CALL == 0)
            call(mynode());
    }
    if (mynode() == 0)
        printf("days %.3f\ncalls %ld\n", dclock() / 86400, calls);
    return 0;
}
