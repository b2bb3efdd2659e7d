/* received_over.c - main receives new limits into the variable that the handler reads: the handler may
 * see half of them.
 * With CORRECT: main receives new limits into a variable of its own, and copies them to the one that the
 * handler reads while the handler is masked.
 * variable: limits */
#include <stdio.h>
#include "nx.h"

enum { VALUE = 5, LIMITS = 6, ENOUGH = 7, VALUES = 6 };
static struct limits {
    double low, high;
} limits = {0, 10};
static double value;
static int inside, seen;

static void on_value(long type, long count, long node, long pid)
{
    inside += limits.low <= value && value <= limits.high; /* RACE */
    if (++seen < VALUES)
        hrecv(VALUE, &value, sizeof value, on_value);
    else
        csend(ENOUGH, NULL, 0, mynode(), 0);
}

int main(void)
{
    struct limits next = {0, 20};
    double x;

    if (mynode() == 0) {
        hrecv(VALUE, &value, sizeof value, on_value);
#ifdef CORRECT
        crecv(LIMITS, &next, sizeof next);
        masktrap(1);
        limits = next;
        masktrap(0);
#else
        crecv(LIMITS, &limits, sizeof limits); /* RACE */
#endif
        crecv(ENOUGH, NULL, 0);
        printf("%d of %d inside\n", inside, seen);
    } else {
        csend(LIMITS, &next, sizeof next, 0, 0);
        for (x = 0; x < VALUES; x++)
            csend(VALUE, &x, sizeof x, 0, 0);
    }
    return 0;
}
