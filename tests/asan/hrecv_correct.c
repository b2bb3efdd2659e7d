/* hrecv_correct.c - as hrecv_fault.c, without its fault.
 * run: -n 2 */
#include <stdio.h>
#include "nx.h"

long news[8];
static volatile int come;

static void on_news(long type, long count, long node, long pid)
{
    come = 1;
}

static void work(void)
{
    while (!come)
        flick();
}

int main(void)
{
    long all[8] = {1, 2, 3, 4, 5, 6, 7, 8};
    if (mynode() == 0) {
        csend(1, all, sizeof all, 1, 0);
        return 0;
    }
    hrecv(1, (char *)news, 8 * sizeof(long), on_news);
    work();
    printf("%ld\n", news[1]);
    return 0;
}
