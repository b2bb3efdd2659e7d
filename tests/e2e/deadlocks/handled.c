/* handled.c - a handler takes the message for which its own program waits. */
#include "nx.h"

static char in[8];

static void take(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
}

int main(void)
{
    char buf[8] = "";

    if (mynode() == 0) {
        hrecv(7, in, sizeof in, take);
        crecv(7, buf, sizeof buf);
    } else {
        csend(7, buf, sizeof buf, 0, 0);
    }
    return 0;
}
