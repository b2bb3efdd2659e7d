/* A handler is not interrupted by another, even if it waits for a message itself; those due run after it, in
 * order.
 * run: -m delta -n 3
 */
#include <nx.h>
#include <stdio.h>

static char box[3][8];
static int inside;

static void handler(long type, long count, long node, long pid)
{
    static char more[8];
    if (inside)
        printf("nested\n");
    inside = 1;
    crecv(20 + node, more, sizeof more); /* comes much later */
    printf("handler for node %ld\n", node);
    inside = 0;
    (void)type, (void)count, (void)pid;
}

int main(void)
{
    char c[8] = {0};
    if (mynode() == 0) {
        hrecv(11, box[1], 8, handler);
        hrecv(12, box[2], 8, handler);
        csend(1, c, 0, 1, 0);
        csend(1, c, 0, 2, 0);
        crecv(31, c, 8);
        crecv(32, c, 8);
        printf("both done\n");
    } else {
        double until;
        crecv(1, c, 8);
        csend(10 + mynode(), c, 8, 0, 0);
        until = dclock() + 0.01 * (double)mynode();
        while (dclock() < until)
            ;
        csend(20 + mynode(), c, 8, 0, 0);
        csend(30 + mynode(), c, 8, 0, 0);
    }
    return 0;
}
