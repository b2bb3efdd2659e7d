/* buffers.c - the nodes send each other more than they have memory for, and receive afterwards. */
#include <stdlib.h>
#include "nx.h"

enum { BYTES = 1 << 20, MESSAGES = 40 };

int main(void)
{
    char *buf = malloc(BYTES);
    int i;

    for (i = 0; i < MESSAGES; i++)
        csend(i, buf, BYTES, 1 - mynode(), 0);
    for (i = 0; i < MESSAGES; i++)
        crecv(i, buf, BYTES);
    return 0;
}
