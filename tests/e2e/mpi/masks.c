/* masktrap(1) holds a handler back while the program computes and while it waits; masktrap(0) lets it run at once. */
#include <nx.h>
#include <stdio.h>

static volatile long handled;

static void handler(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    handled++;
}

static void compute_until(double t)
{
    while (dclock() < t)
        ;
}

int main(void)
{
    long before;
    if (mynode() == 1) {
        crecv(1, 0, 0);
        csend(2, 0, 0, 0, 0);
        csend(3, 0, 0, 0, 0);
        return 0;
    }
    hrecv(2, 0, 0, handler);
    masktrap(1);
    csend(1, 0, 0, 1, 0);
    crecv(3, 0, 0); /* type 2 is there */
    compute_until(dclock() + 0.05);
    printf("masked: %ld\n", handled);
    before = masktrap(0);
    printf("unmasked: %ld, it was %ld\n", handled, before);
    return 0;
}
