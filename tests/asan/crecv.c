/* crecv.c - a message is longer than the array, and crecv was told of as much room as the message needs.
 * report: stack-buffer-overflow: write of 400 bytes, the last 200 of them just behind all (200 bytes,
 * run: -n 2 */
#include <stdio.h>
#include "nx.h"

enum { N = 100 };

static void receive(void)
{
#ifdef CORRECT
    int all[N];
#else
    int all[N / 2];
#endif
    crecv(1, all, N * sizeof(int)); /* FAULT */
    printf("%d\n", all[3]);
}

int main(void)
{
    int all[N], i;
    for (i = 0; i < N; i++)
        all[i] = i;
    if (mynode() == 0)
        csend(1, all, sizeof all, 1, 0);
    else
        receive();
    return 0;
}
