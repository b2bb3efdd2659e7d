/* deadlock.c - every node waits, each in another call, for a message that no node sends. */
#include "nx.h"

int main(void)
{
    char buf[8];

    if (mynode() == 0)
        crecv(7, buf, sizeof buf);
    else if (mynode() == 1)
        cprobe(-1);
    else if (mynode() == 2)
        msgwait(irecv(9, buf, sizeof buf));
    else
        gsync();
    return 0;
}
