/* pointers.c - main and the handler reach one account through pointers that they give to functions; main
 * does not mask the handler. In the usual run the handler comes while main waits in crecv.
 * With CORRECT: main and the handler reach accounts through pointers that they give to functions: main
 * its own account, the handler another one.
 * variable: cash */
#include <stdio.h>
#include "nx.h"

enum { PAY = 5, ENOUGH = 6, PAYS = 3 };
struct account {
    long cash, entries;
};
static struct account ours, theirs;
static long amount, pays;

static void put(struct account *a, long what)
{
    a->cash += what; /* RACE */
}

static void take(struct account *a, long what)
{
    a->cash -= what; /* RACE */
}

static void on_pay(long type, long count, long node, long pid)
{
    put(&theirs, amount);
    if (++pays < PAYS)
        hrecv(PAY, &amount, sizeof amount, on_pay);
    else
        csend(ENOUGH, NULL, 0, mynode(), 0);
}

int main(void)
{
    struct account *a[2] = {&ours, &theirs};
    long i;

    if (mynode() == 0) {
        hrecv(PAY, &amount, sizeof amount, on_pay);
        for (i = 0; i < 10; i++)
#ifdef CORRECT
            take(a[0], i);
#else
            take(a[i % 2], i);
#endif
        crecv(ENOUGH, NULL, 0);
        printf("%ld\n", ours.cash + theirs.cash);
    } else {
        for (i = 100; i < 100 + PAYS; i++)
            csend(PAY, &i, sizeof i, 0, 0);
    }
    return 0;
}
