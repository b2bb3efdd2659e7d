/* parameter.c - the parameter of hrecvx tells the handler which slot is its own. Main works in slot 2 and
 * gives the handler the same: they change it without masktrap.
 * With CORRECT: main works in slot 2, the handler in slots 0 and 1.
 * variable: slot */
#include <stdio.h>
#include "nx.h"

enum { FIRST = 5, SECOND = 6, END = 7 };
static long slot[3], first, second;

static void add(long type, long count, long node, long pid, long which)
{
    slot[which] += type; /* RACE */
}

int main(void)
{
    int i;

    if (mynode() == 0) {
        hrecvx(FIRST, &first, sizeof first, 1, -1, add, 0);
#ifdef CORRECT
        hrecvx(SECOND, &second, sizeof second, 1, -1, add, 1);
#else
        hrecvx(SECOND, &second, sizeof second, 1, -1, add, 2);
#endif
        for (i = 0; i < 10; i++)
            slot[2] += i; /* RACE */
        crecv(END, NULL, 0);
        masktrap(1);
        printf("%s\n", slot[2] >= 45 ? "all added" : "lost");
    } else {
        csend(FIRST, &first, sizeof first, 0, 0);
        csend(SECOND, &second, sizeof second, 0, 0);
        csend(END, NULL, 0, 0, 0);
    }
    return 0;
}
