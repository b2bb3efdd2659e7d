/* knot.c - all nodes wait for a first message; node 0, which was to send it, does so, too. */
#include "nx.h"

int main(void)
{
    char buf[8];

    crecv(7, buf, sizeof buf);
    return 0;
}
