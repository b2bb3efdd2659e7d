/* exited.c - node 1 gives up; node 0 waits for its message, and the others for node 0. */
#include <stdlib.h>
#include "nx.h"

int main(void)
{
    long part = 1;

    if (mynode() == 1)
        exit(1);
    if (mynode() == 0)
        crecvx(7, &part, sizeof part, 1, -1, msginfo);
    gsync();
    return 0;
}
