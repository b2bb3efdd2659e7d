/* crecv_correct.c - as crecv_fault.c, without its fault.
 * run: -n 2 */
#include <stdio.h>
#include "nx.h"

enum { N = 100 };

static void receive(void)
{
    int all[N];
    crecv(1, all, N * sizeof(int));
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
