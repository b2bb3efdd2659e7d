/* flag.c - the handler hands a result over by a flag that is not volatile: the compiler may keep the flag
 * in a register, and then main never sees it. (The loop has a limit, so that this program ends.)
 * With CORRECT: the handler hands a result over by a volatile flag; main sends the result when it has
 * seen the flag, after which the handler does not run again.
 * variable: ready */
#include <stdio.h>
#include "nx.h"

#ifdef CORRECT
enum { RESULT = 5, DOUBLED = 6 };
static double result, got;
static volatile int ready;
#else
enum { RESULT = 5, DOUBLED = 6, READY = 7, LIMIT = 100000 };
static double result, got;
static int ready;
#endif

static void on_result(long type, long count, long node, long pid)
{
    result = 2 * got;
    ready = 1; /* RACE */
#ifndef CORRECT
    csend(READY, NULL, 0, mynode(), 0);
#endif
}

int main(void)
{
    double x = 21;
#ifndef CORRECT
    long turns;
#endif

    if (mynode() == 0) {
        hrecv(RESULT, &got, sizeof got, on_result);
#ifdef CORRECT
        while (!ready)
            ;
#else
        for (turns = 0; !ready && turns < LIMIT; turns++) /* RACE */
            ;
        if (turns == LIMIT)
            crecv(READY, NULL, 0);
#endif
        csend(DOUBLED, &result, sizeof result, 1, 0);
    } else {
        csendrecv(RESULT, &x, sizeof x, 0, 0, DOUBLED, &x, sizeof x);
        printf("%g\n", x);
    }
    return 0;
}
