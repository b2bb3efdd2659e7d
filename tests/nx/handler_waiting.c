/* Handlers run while the program waits in a call, held back by masktrap(1) and let run at once by
 * masktrap(0); what infocount() says to the program is not disturbed by them.
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 */
#include <nx.h>
#include <stdio.h>

static char box[64];
static int handled;

static void handler(long type, long count, long node, long pid)
{
    long before = masktrap(1);
    handled++;
    printf("handler: type %ld, %ld bytes, node %ld, info %ld\n", type, count, node, infocount());
    if (handled < 3)
        hrecv(5, box, sizeof box, handler);
    masktrap(before);
    (void)pid;
}

int main(void)
{
    static char buf[64];
    if (mynode() == 0) {
        hrecv(5, box, sizeof box, handler);
        crecv(6, buf, sizeof buf); /* one handler runs in here */
        printf("received %ld bytes, %d handled\n", infocount(), handled);
        masktrap(1);
        csend(7, buf, 0, 1, 0);
        crecv(8, buf, sizeof buf);
        printf("masked: %d handled\n", handled);
        printf("masktrap says %ld\n", masktrap(0));
        printf("unmasked: %d handled\n", handled);
        csend(10, buf, 0, 1, 0);
        crecv(9, buf, sizeof buf);
        printf("at the end: %d handled, info %ld\n", handled, infocount());
    } else {
        csend(5, buf, 11, 0, 0);
        csend(6, buf, 22, 0, 0);
        crecv(7, buf, sizeof buf);
        csend(5, buf, 33, 0, 0);
        csend(8, buf, 44, 0, 0);
        crecv(10, buf, sizeof buf);
        csend(5, buf, 55, 0, 0);
        csend(9, buf, 1, 0, 0);
    }
    return 0;
}
