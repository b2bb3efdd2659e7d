/* two_handlers.c - two handlers are posted with one buffer: a message for one may come while the other
 * still has to read its own, or reads it.
 * With CORRECT: two handlers are posted, each with a buffer of its own; both change `total`, which is
 * safe, since no handler interrupts another.
 * variable: word */
#include <stdio.h>
#include "nx.h"

enum { PLUS = 5, MINUS = 6, ENOUGH = 7 };
#ifdef CORRECT
static long word, other, total, runs;
#else
static long word, total, runs;
#endif

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
#ifdef CORRECT
    total -= other;
#else
    total -= word;
#endif
    ran();
}

int main(void)
{
    long ten = 10, three = 3;

    if (mynode() == 0) {
        hrecv(PLUS, &word, sizeof word, on_plus); /* RACE */
#ifdef CORRECT
        hrecv(MINUS, &other, sizeof other, on_minus);
#else
        hrecv(MINUS, &word, sizeof word, on_minus); /* RACE */
#endif
        crecv(ENOUGH, NULL, 0);
        printf("total %ld\n", total);
    } else {
        csend(PLUS, &ten, sizeof ten, 0, 0);
        csend(MINUS, &three, sizeof three, 0, 0);
    }
    return 0;
}
