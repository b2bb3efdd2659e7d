/* whole_struct.c - main copies a struct as a whole that the handler assigns as a whole: neither copy is
 * one instruction, so main may get a mixture.
 * With CORRECT: main masks the handler for as long.
 * variable: best */
#include <stdio.h>
#include "nx.h"

enum { FOUND = 5, ENOUGH = 6, FINDS = 5 };
struct tour {
    long length, city[12];
};
static struct tour best = {1000}, found;
static int finds;

static void on_found(long type, long count, long node, long pid)
{
    if (found.length < best.length)
        best = found; /* RACE */
    if (++finds < FINDS)
        hrecv(FOUND, &found, sizeof found, on_found);
    else
        csend(ENOUGH, NULL, 0, mynode(), 0);
}

int main(void)
{
    struct tour t = {0};
    int i, k;

    if (mynode() == 0) {
        hrecv(FOUND, &found, sizeof found, on_found);
#ifdef CORRECT
        masktrap(1);
        t = best;
        masktrap(0);
#else
        t = best; /* RACE */
#endif
        crecv(ENOUGH, NULL, 0);
        printf("%ld to %ld, %ld to %ld\n", t.length, best.length, t.city[11], best.city[11]);
    } else {
        for (i = 0; i < FINDS; i++) {
            t.length = 900 - 10 * i;
            for (k = 0; k < 12; k++)
                t.city[k] = i + k;
            csend(FOUND, &t, sizeof t, 0, 0);
        }
    }
    return 0;
}
