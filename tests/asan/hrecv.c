/* hrecv.c - a handler is posted with a short buffer.
 * report: global-buffer-overflow: write of 64 bytes, the last 32 of them just behind news (32 bytes,
 * run: -n 2 */
#include <stdio.h>
#include "nx.h"

#ifdef CORRECT
long news[8];
#else
long news[4];
#endif
static volatile int come;

static void on_news(long type, long count, long node, long pid)
{
    come = 1;
}

static void work(void)
{
    while (!come) /* FAULT */
        flick();  /* FAULT */
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
