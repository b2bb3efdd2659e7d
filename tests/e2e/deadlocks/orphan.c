/* orphan.c - node 0 waits for a message that nobody sends, and all others wait for node 0. */
#include "nx.h"

int main(void)
{
    char buf[8];

    if (mynode() == 0)
        crecv(7, buf, sizeof buf);
    gsync();
    return 0;
}
