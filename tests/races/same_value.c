/* same_value.c - a handler sets a flag and takes it for its own. In this run the flag is set already when
 * the handler comes, so that it finds and leaves the same value; had it come a little later, main's
 * clearing it would be lost.
 * With CORRECT: main clears it only while handlers are masked.
 * variable: flag
 * run: -n 2 */
#include <stdio.h>
#include "nx.h"

static int flag = 1;
static long request, sum;
static double work = 1;

static void serve(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)pid;
    flag = 1; /* RACE */
    csend(2, &request, sizeof request, node, 0);
    hrecv(1, &request, sizeof request, serve);
    flag = 1;
}

int main(void)
{
    long got;

    if (mynode() == 0)
        hrecv(1, &request, sizeof request, serve);
    gsync();
    for (long i = 0; i < 20; i++)
        if (mynode() == 1) {
            csend(1, &i, sizeof i, 0, 0);
            crecv(2, &got, sizeof got);
            sum += got;
        }
    for (long i = 0; i < 200000 && mynode() == 0; i++)
        work = work * 0.5 + 1;
    if (mynode() == 0)
#ifdef CORRECT
        masktrap(1), flag = 0, masktrap(0);
#else
        flag = 0; /* RACE */
#endif
    gsync();
    if (mynode() == 1)
        printf("%ld %d %g\n", sum, flag, work);
    return 0;
}
