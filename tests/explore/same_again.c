/* same_again.c - main takes the first cell of a list without masking handlers for long: it reads the first
 * cell and its next one, prepares, and then makes the next one the first, if the first is still the same (the
 * ABA problem). One handler takes two cells, the other puts the first of them back.
 *
 * bad outcome: wrong output: the cell that the handler keeps is on the list again
 * depth: 3 (main reads < two are taken, two are taken < one is put back, one is put back < main compares)
 * nodes: 3
 * good: the line "each cell has one owner"
 * delay: node 1's message by 210 to 380 us, and node 2's so that its handler runs after node 1's, and less
 * than 500 us */
#include <stdio.h>
#include "nx.h"
#include "work.h"

enum { TAKE = 5, PUT_BACK = 6, ENOUGH = 7, CELLS = 5 };
static struct cell {
    struct cell *next;
    int owners;
} cell[CELLS], *first, *spare;
static int runs;

static struct cell *take(void)
{
    struct cell *c = first;

    first = c->next;
    return c;
}

static void ran(void)
{
    if (++runs == 2)
        csend(ENOUGH, NULL, 0, mynode(), 0);
}

static void on_take(long type, long count, long node, long pid)
{
    spare = take();
    take()->owners++;
    ran();
}

static void on_put_back(long type, long count, long node, long pid)
{
    if (spare) {
        spare->next = first;
        first = spare;
        spare = NULL;
    }
    ran();
}

/* Takes the first cell, as take(), but handlers may run meanwhile. */
static struct cell *take_open(void)
{
    struct cell *seen, *next;
    int same;

    do {
        seen = first;
        next = seen->next;
        work(200);
        masktrap(1);
        if ((same = first == seen))
            first = next;
        masktrap(0);
    } while (!same);
    return seen;
}

static void report(void)
{
    struct cell *c;
    int i, wrong = 0;

    for (c = first; c; c = c->next)
        c->owners++;
    if (spare)
        spare->owners++;
    for (i = 0; i < CELLS; i++)
        wrong += cell[i].owners != 1;
    printf(wrong ? "%d cells have not one owner\n" : "each cell has one owner\n", wrong);
}

int main(void)
{
    int i;

    if (mynode() == 0) {
        for (i = 0; i < CELLS; i++)
            cell[i].next = i + 1 < CELLS ? &cell[i + 1] : NULL;
        first = cell;
        hrecv(TAKE, NULL, 0, on_take);
        hrecv(PUT_BACK, NULL, 0, on_put_back);
        work(250);
        take_open()->owners++;
        crecv(ENOUGH, NULL, 0);
        report();
    } else {
        late(1);
        work(30 * (mynode() - 1));
        csend(mynode() == 1 ? TAKE : PUT_BACK, NULL, 0, 0, 0);
    }
    return 0;
}
