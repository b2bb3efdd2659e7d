/* A handler interrupts a computation at the virtual time its message is complete, to the first poll after
 * it, and may post itself again; results do not depend on how the simulator slices the computing (see
 * --slice).
 * run: -m ipsc860 -n 2
 * run: -m ipsc860 -n 2 --slice 0.001
 * run: -m ipsc860 -n 2 --slice 0.000001
 */
#include <math.h>
#include <nx.h>
#include <stdio.h>

static char box[100];
static volatile int handled;
static volatile double began;

static void handler(long type, long count, long node, long pid)
{
    handled++;
    began = dclock();
    hrecv(type, box, sizeof box, handler);
    (void)count, (void)node, (void)pid;
}

int main(void)
{
    long i, k;
    double x = 0;
    if (mynode() == 0) {
        int seen = 0;
        hrecv(5, box, sizeof box, handler);
        for (i = 0; i < 200000; i++) {
            x += 1.0 / (double)(i + 1);
            if (handled != seen)
                printf("handler %d began at %.9f, before iteration %ld\n", seen = handled, began, i);
        }
        crecv(6, box, 0);
        printf("sum %.6f, %d handled, %.9f s\n", x, handled, dclock());
    } else {
        for (k = 0; k < 5; k++) {
            for (i = 0; i < 10000; i++)
                x += sqrt((double)i);
            csend(5, box, sizeof box, 0, 0);
        }
        csend(6, box, 0, 0, 0);
    }
    return 0;
}
