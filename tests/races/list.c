/* list.c - the handler puts cells on a list from which main takes them. Main does so without masktrap:
 * cells that the handler adds meanwhile are lost. In the usual run the messages come after main's last
 * take.
 * With CORRECT: main masks the handler while it takes one, and counts the rest after the handler has run
 * for the last time (ENOUGH).
 * variable: list */
#include <stdio.h>
#include "nx.h"

enum { ITEM = 5, ENOUGH = 6, ITEMS = 10 };
static struct cell {
    struct cell *next;
    long value;
} cells[2 * ITEMS], *list;
static long item, used;

static void add(long value)
{
    cells[used].value = value;
    cells[used].next = list;
    list = &cells[used++]; /* RACE */
}

static void on_item(long type, long count, long node, long pid)
{
    add(item);
    if (used == 2 * ITEMS)
        csend(ENOUGH, NULL, 0, mynode(), 0);
    else
        hrecv(ITEM, &item, sizeof item, on_item);
}

int main(void)
{
    struct cell *c;
    long i, sum = 0;

    if (mynode() == 0) {
        for (i = 0; i < ITEMS; i++)
            add(i);
        hrecv(ITEM, &item, sizeof item, on_item);
        for (i = 0; i < ITEMS; i++) {
#ifdef CORRECT
            masktrap(1);
            list = (c = list)->next;
            masktrap(0);
#else
            list = (c = list)->next; /* RACE */
#endif
            sum += c->value;
        }
        crecv(ENOUGH, NULL, 0);
        for (c = list; c; c = c->next)
            sum += c->value;
        printf("sum %ld\n", sum);
    } else {
        for (i = 0; i < 300; i++)
            flick();
        for (i = 0; i < ITEMS; i++)
            csend(ITEM, &i, sizeof i, 0, 0);
    }
    return 0;
}
