/* A forced message is dropped when nothing is posted, and goes straight into a posted receive at any length.
 * run: -m ipsc860 -n 2
 */
#include <nx.h>
#include <stdio.h>

enum { FORCED = 0x40000000 };
static char buf[5000];

int main(void)
{
    if (mynode() == 0) {
        csend(FORCED | 1, buf, 5000, 1, 0); /* nothing posted */
        csend(2, buf, 0, 1, 0);
        crecv(3, buf, 0);
        csend(FORCED | 1, buf, 4000, 1, 0); /* posted */
    } else {
        long id;
        crecv(2, buf, 0);
        printf("the first has %s\n", iprobe(FORCED | 1) ? "been kept" : "been dropped");
        id = irecv(FORCED | 1, buf, sizeof buf);
        csend(3, buf, 0, 0, 0);
        msgwait(id);
        printf("the second has %ld bytes\n", infocount());
    }
    return 0;
}
