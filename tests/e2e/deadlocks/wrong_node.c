/* wrong_node.c - node 0 waits for a message from node 1; node 2 has sent it. */
#include "nx.h"

int main(void)
{
    char buf[8] = "";
    long info[8];

    if (mynode() == 0)
        crecvx(7, buf, sizeof buf, 1, -1, info);
    else if (mynode() == 2)
        csend(7, buf, sizeof buf, 0, 0);
    gsync();
    return 0;
}
