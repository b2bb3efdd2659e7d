/* sends.c - node: has sends of every kind under way when it is killed. */
#include "cube.h"

static char bytes[20000];

static void handler(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
}

int main(void)
{
    long said[2] = {mynode(), 0};
    csend(2, said, sizeof said, myhost(), 0);
    for (;;) {
        isend(50, bytes, sizeof bytes, 2, 0);
        hsend(51, bytes, sizeof bytes, 2, 0, handler);
        csend(53, bytes, sizeof bytes, 1, 0);
        csend(53, bytes, sizeof bytes, myhost(), 0);
    }
}
