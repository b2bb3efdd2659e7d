/* own_types.c - of many nodes, each second one waits for a message of a type of its own, which nobody sends; the
 * others wait for these. */
#include "nx.h"

int main(void)
{
    char buf[8];

    if (mynode() % 2)
        crecv(1000 + mynode(), buf, sizeof buf);
    gsync();
    return 0;
}
