/* flushmsg throws away what has come in, long messages that wait for their data too; what is not selected
 * stays.
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 */
#include <nx.h>
#include <stdio.h>

static char buf[100000];

int main(void)
{
    long i;
    if (mynode() == 1) {
        for (i = 0; i < 200; i++) /* more than a node holds: the last ones wait for room */
            isend(1, buf, sizeof buf, 0, 0);
        csend(2, buf, 5, 0, 0);
        crecv(3, buf, 0);
        csend(1, buf, 7, 0, 0);
        csend(4, buf, 0, 0, 0);
        return 0;
    }
    cprobe(2);
    flushmsg(1, mynode(), 0);
    printf("type 1 is %s, type 2 is %s\n", iprobe(1) ? "there" : "gone", iprobe(2) ? "there" : "gone");
    csend(3, buf, 0, 1, 0);
    cprobe(4);
    crecv(1, buf, sizeof buf);
    printf("later: %ld bytes\n", infocount());
    crecv(2, buf, sizeof buf);
    flushmsg(-1, -1, -1);
    printf("type 4 is %s\n", iprobe(4) ? "there" : "gone");
    return 0;
}
