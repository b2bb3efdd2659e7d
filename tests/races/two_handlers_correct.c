/* two_handlers_correct.c - two handlers are posted, each with a buffer of its own; both change `total`,
 * which is safe, since no handler interrupts another. */
#include <stdio.h>
#include "nx.h"

enum { PLUS = 5, MINUS = 6, ENOUGH = 7 };
static long word, other, total, runs;

static void ran(void)
{
    if (++runs == 2)
        csend(ENOUGH, NULL, 0, mynode(), 0);
}

static void on_plus(long type, long count, long node, long pid)
{
    total += word;
    ran();
}

static void on_minus(long type, long count, long node, long pid)
{
    total -= other;
    ran();
}

int main(void)
{
    long ten = 10, three = 3;

    if (mynode() == 0) {
        hrecv(PLUS, &word, sizeof word, on_plus);
        hrecv(MINUS, &other, sizeof other, on_minus);
        crecv(ENOUGH, NULL, 0);
        printf("total %ld\n", total);
    } else {
        csend(PLUS, &ten, sizeof ten, 0, 0);
        csend(MINUS, &three, sizeof three, 0, 0);
    }
    return 0;
}
