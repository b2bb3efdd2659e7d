/* A message for a computing node whose operating system is behind with others is complete only after the node
 * has begun to wait for it; it wakes the node then, though nothing else happens on the machine any more.
 * run: -m ipsc860 -n 16
 */
#include <nx.h>
#include <stdio.h>

enum { DATA = 1, ANSWER, DROPPED = 1 << 30, BYTES = 65536 };
static char buf[BYTES];

static void compute_until(double t)
{
    while (dclock() < t)
        ;
}

int main(void)
{
    double begin;
    long id = -1;
    volatile long work = 0;
    if (mynode() < 2)
        id = irecv(mynode() ? DATA : ANSWER, buf, BYTES);
    gsync();
    begin = dclock();
    if (mynode() == 0) {
        csend(DATA, buf, BYTES, 1, 0); /* 25.6 ms on the wire */
        while (work < 1000)            /* 0.2 ms */
            work++;
        msgwait(id);
        printf("%s\n", dclock() - begin > 0.027 ? "answered, after the others" : "answered early");
    } else if (mynode() == 1) {
        msgwait(id);
        csend(ANSWER, buf, 0, 0, 0);
    } else if (mynode() == 2 || mynode() == 4 || mynode() == 8) { /* its neighbours */
        compute_until(begin + 0.0245);
        for (int i = 0; i < 30; i++) /* node 0 takes 30 us to drop each; they come every 12 us */
            csend(DROPPED, buf, 0, 0, 0);
    }
    return 0;
}
