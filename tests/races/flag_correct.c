/* flag_correct.c - the handler hands a result over by a volatile flag; main sends the result when it has
 * seen the flag, after which the handler does not run again. */
#include <stdio.h>
#include "nx.h"

enum { RESULT = 5, DOUBLED = 6 };
static double result, got;
static volatile int ready;

static void on_result(long type, long count, long node, long pid)
{
    result = 2 * got;
    ready = 1;
}

int main(void)
{
    double x = 21;

    if (mynode() == 0) {
        hrecv(RESULT, &got, sizeof got, on_result);
        while (!ready)
            ;
        csend(DOUBLED, &result, sizeof result, 1, 0);
    } else {
        csendrecv(RESULT, &x, sizeof x, 0, 0, DOUBLED, &x, sizeof x);
        printf("%g\n", x);
    }
    return 0;
}
