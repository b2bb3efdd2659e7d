/* waits.c - the nodes wait for one another's end. */
#include "nx.h"

int main(void)
{
    waitall(1 - mynode(), 0);
    return 0;
}
