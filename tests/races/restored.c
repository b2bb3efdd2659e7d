/* restored.c - a handler puts variables back as it found them: a flag, a double, and how deep the program
 * is in calls; but this not always. When it did not, and main was between reading and writing, the depth
 * is wrong.
 * With CORRECT: always. Whatever main does with them when the handler comes, main finds the same afterwards.
 * variable: depth
 * run: -n 2 */
#include <stdio.h>
#include "nx.h"

static int depth, deepest;
static char inside, other = 1;
static double scale = 2;
static long request, sum;
static int served;

static void serve(long type, long count, long node, long pid)
{
    double before = scale;
    (void)type, (void)count, (void)pid;
    depth++; /* RACE */
    inside = 1;
    scale = 0.5;
    csend(2, &request, sizeof request, node, 0);
    hrecv(1, &request, sizeof request, serve);
    scale = before;
    inside = 0;
    served++;
#ifdef CORRECT
    depth--;
#else
    depth -= served != 7;
#endif
}

int main(void)
{
    long got;

    if (mynode() == 0)
        hrecv(1, &request, sizeof request, serve);
    gsync();
    for (long i = 0; i < 20; i++) {
        depth++; /* RACE */
        scale *= 2;
        deepest = deepest > depth ? deepest : depth;
        if (mynode() == 1) {
            csend(1, &i, sizeof i, 0, 0);
            crecv(2, &got, sizeof got);
            sum += got;
        }
        other += inside;
        depth--;
    }
    gsync();
    if (mynode() == 1)
        printf("%ld %d %d %d %g\n", sum, depth, deepest, other, scale);
    return 0;
}
