/* A handler that becomes due just while the program enters a call that waits is run, whenever that is.
 * run: -m ipsc860 -n 2
 */
#include <nx.h>
#include <stdio.h>

static char box[200];

static void handler(long type, long count, long node, long pid)
{
    csend(2, "", 0, 0, 0);
    (void)type, (void)count, (void)node, (void)pid;
}

int main(void)
{
    static volatile int x;
    int delay, i;
    for (delay = 0; delay < 4000; delay++) {
        if (mynode() == 0) {
            hrecv(1, box, sizeof box, handler);
            csend(3, "", 0, 1, 0);
            for (i = 0; i < delay; i++)
                x++;
            crecv(2, box, 0); /* sent by the handler */
        } else {
            crecv(3, box, 0);
            csend(1, box, delay & 1 ? 136 : 8, 0, 0);
        }
    }
    if (mynode() == 0)
        printf("4000 handled\n");
    return 0;
}
