/* churn_node.c - node: sends, receives, writes, computes, in every way that can be cut short; see churn.c. */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "cube.h"

static long state, bytes[6000], other[6000], more[6000];
static volatile double x = 1;

static long random_below(long n)
{
    state = (state * 1103515245 + 12345) & 0x7fffffff;
    return state / 65536 % n;
}

static void handler(long type, long count, long node, long pid)
{
    (void)count, (void)pid;
    if (random_below(2))
        csend(70, more, 8 * random_below(300), myhost(), 1);
    if (node != myhost())
        csend(80, more, 8 * random_below(300), node, 0);
    hrecv(type, bytes, sizeof bytes, handler);
}

static void sent(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
}

int main(void)
{
    char name[40];
    state = mynode() * 7919 + mclock();
    snprintf(name, sizeof name, "/cfs/churn%ld", mynode());
    int fd = open(name, O_RDWR | O_CREAT, 0666);
    hrecv(1, bytes, sizeof bytes, handler);
    hrecv(60, bytes, sizeof bytes, handler);
    for (;;) {
        switch (random_below(9)) {
        case 0:
            csend(60 + random_below(3), other, 8 * random_below(4000), random_below(numnodes() + 1) - 1, 0);
            break;
        case 1:
            isend(60, other, 8 * random_below(4000), random_below(numnodes()), 0);
            break;
        case 2:
            hsend(61, other, 8 * random_below(4000), random_below(numnodes()), 0, sent);
            break;
        case 3:
            irecv(61, other, sizeof other);
            break;
        case 4:
            cread(fd, other, 8 * (unsigned long)random_below(4000));
            break;
        case 5:
            iwrite(fd, other, 8 * (unsigned long)random_below(4000));
            break;
        case 6:
            if (iprobe(2))
                crecv(2, other, sizeof other);
            break;
        case 7:
            csend(70 | 1 << 30, other, 8 * random_below(100), myhost(), 1);
            break;
        default:
            for (long i = random_below(20000); i > 0; i--)
                x = x * 0.999 + 1;
        }
        if (random_below(200) == 0)
            return 0;
    }
}
