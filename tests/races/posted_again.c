/* posted_again.c - the handler posts itself again before it has read the buffer: the next message may be
 * put there while the handler still runs.
 * With CORRECT: it does so when it has read the buffer: until then no receive is posted for it, and the
 * next message waits elsewhere.
 * variable: item */
#include <stdio.h>
#include "nx.h"

enum { ITEM = 5, ENOUGH = 6, ITEMS = 6 };
static long item, items, sum;

static void on_item(long type, long count, long node, long pid)
{
#ifdef CORRECT
    sum += item;
#endif
    if (++items < ITEMS)
        hrecv(ITEM, &item, sizeof item, on_item); /* RACE */
#ifndef CORRECT
    sum += item; /* RACE */
#endif
    if (items == ITEMS)
        csend(ENOUGH, NULL, 0, mynode(), 0);
}

int main(void)
{
    long i;

    if (mynode() == 0) {
        hrecv(ITEM, &item, sizeof item, on_item);
        crecv(ENOUGH, NULL, 0);
        printf("sum %ld\n", sum);
    } else {
        for (i = 1; i <= ITEMS; i++)
            csend(ITEM, &i, sizeof i, 0, 0);
    }
    return 0;
}
