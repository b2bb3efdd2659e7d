/* first_comes.c - whose message comes first? All nodes compute alike and send to node 0, which receives from
 * any, by crecv and by a handler. */
#include <nx.h>
#include <stdio.h>

enum { REPORT = 1, INTERRUPT = 2, GO = 3 };

static volatile long first_interrupt = -1;
static long interrupting;

static void interrupted(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)pid;
    if (first_interrupt < 0)
        first_interrupt = node;
    if (first_interrupt != node)
        return;
    hrecv(INTERRUPT, &interrupting, sizeof interrupting, interrupted);
}

static long work(long n)
{
    volatile long x = 0;
    for (long i = 0; i < n; i++)
        x += i;
    return x;
}

static void receive_all(void)
{
    long from;
    for (long i = 1; i < numnodes(); i++) {
        crecv(REPORT, &from, sizeof from);
        printf("%ld ", from);
    }
    printf("first interrupt by %ld\n", first_interrupt);
}

int main(void)
{
    long me = mynode();
    if (me == 0) {
        hrecv(INTERRUPT, &interrupting, sizeof interrupting, interrupted);
        work(100000);
        receive_all();
    } else {
        work(1000);
        csend(INTERRUPT, &me, sizeof me, 0, 0);
        csend(REPORT, &me, sizeof me, 0, 0);
    }
    gsync();
    return 0;
}
