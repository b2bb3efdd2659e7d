/* flag_fault.c - the handler hands a result over by a flag that is not volatile: the compiler may keep the
 * flag in a register, and then main never sees it. (The loop has a limit, so that this program ends.)
 * variable: ready */
#include <stdio.h>
#include "nx.h"

enum { RESULT = 5, DOUBLED = 6, READY = 7, LIMIT = 100000 };
static double result, got;
static int ready;

static void on_result(long type, long count, long node, long pid)
{
    result = 2 * got;
    ready = 1; /* RACE */
    csend(READY, NULL, 0, mynode(), 0);
}

int main(void)
{
    double x = 21;
    long turns;

    if (mynode() == 0) {
        hrecv(RESULT, &got, sizeof got, on_result);
        for (turns = 0; !ready && turns < LIMIT; turns++) /* RACE */
            ;
        if (turns == LIMIT)
            crecv(READY, NULL, 0);
        csend(DOUBLED, &result, sizeof result, 1, 0);
    } else {
        csendrecv(RESULT, &x, sizeof x, 0, 0, DOUBLED, &x, sizeof x);
        printf("%g\n", x);
    }
    return 0;
}
