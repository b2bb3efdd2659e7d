/* posts.c - node: has receives of every kind posted when it is killed. */
#include "cube.h"

static char long_one[20000], other[20000];

static void handler(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
}

int main(void)
{
    hrecv(51, other, sizeof other, handler);
    irecv(50, long_one, sizeof long_one);
    long id = irecv(52, other, sizeof other);
    msgwait(id);
    return 0;
}
