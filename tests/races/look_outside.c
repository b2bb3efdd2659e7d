/* look_outside.c - main masks the handler while it takes a ticket, but not while it looks whether there
 * is one. Between looking and taking the handler may take the last one.
 * With CORRECT: main looks whether there is a ticket and takes it without letting the handler run in
 * between: one masktrap encloses both.
 * variable: tickets */
#include <stdio.h>
#include "nx.h"

enum { WANT = 5, ENOUGH = 6, WANTS = 4 };
static long tickets = 6, given, wants;

static void on_want(long type, long count, long node, long pid)
{
    if (tickets > 0)
        tickets--, given++; /* RACE */
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
#ifdef CORRECT
            masktrap(1);
            if (tickets > 0) {
                tickets--;
#else
            if (tickets > 0) { /* RACE */
                masktrap(1);
                tickets--;
                masktrap(0);
#endif
                taken++;
            }
#ifdef CORRECT
            masktrap(0);
#endif
        }
        crecv(ENOUGH, NULL, 0);
        printf("%ld of 6 given\n", taken + given);
    } else {
        for (i = 0; i < WANTS; i++)
            csend(WANT, NULL, 0, 0, 0);
    }
    return 0;
}
