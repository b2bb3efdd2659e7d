/* look_outside_correct.c - main looks whether there is a ticket and takes it without letting the handler
 * run in between: one masktrap encloses both. */
#include <stdio.h>
#include "nx.h"

enum { WANT = 5, ENOUGH = 6, WANTS = 4 };
static long tickets = 6, given, wants;

static void on_want(long type, long count, long node, long pid)
{
    if (tickets > 0)
        tickets--, given++;
    if (++wants < WANTS)
        hrecv(WANT, NULL, 0, on_want);
    else
        csend(ENOUGH, NULL, 0, mynode(), 0);
}

int main(void)
{
    int i, taken = 0;

    if (mynode() == 0) {
        hrecv(WANT, NULL, 0, on_want);
        for (i = 0; i < 3; i++) {
            masktrap(1);
            if (tickets > 0) {
                tickets--;
                taken++;
            }
            masktrap(0);
        }
        crecv(ENOUGH, NULL, 0);
        printf("%ld of 6 given\n", taken + given);
    } else {
        for (i = 0; i < WANTS; i++)
            csend(WANT, NULL, 0, 0, 0);
    }
    return 0;
}
