/* The address of errno may be kept, also while the program waits and goes on elsewhere; a handler
 * finds it at the same address.
 * run: all
 * run: -w 2 -m delta -n 40
 * run: -w 2 --shuffle 3 -m delta -n 40
 * run: --engine reference -m delta -n 40
 */
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include "rule.h"

static int *volatile kept;
static volatile int found; /* by the handler */

static void handler(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    found = &errno == kept ? 1 : -1;
}

/* Long enough that another thread may have the program. */
static void compute(void)
{
    for (volatile long i = 0; i < 20000; i++)
        ;
}

static void ring(long round)
{
    long me = mynode(), got = -1;
    compute();
    csend(round, &me, sizeof me, next_node(), 0);
    crecv(round, &got, sizeof got);
    rule("the ring", got == last_node());
}

int main(void)
{
    char byte;
    kept = &errno;
    for (int round = 0; round < 5; round++) {
        *kept = 100 + (int)mynode();
        ring(round);
        rule("kept over a wait", *kept == 100 + mynode() && errno == *kept && kept == &errno);
        rule("what the library sets",
             strtol("99999999999999999999", NULL, 10) == LONG_MAX && *kept == ERANGE);
        *kept = 0;
        rule("and leaves", strtol("99", NULL, 10) == 99 && errno == 0);
    }
    hrecv(50, &byte, 1, handler);
    csend(50, &byte, 1, next_node(), 0);
    while (!found)
        flick();
    rule("in a handler", found == 1);
    return 0;
}
