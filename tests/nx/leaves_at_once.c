/* A message of 100 bytes or less is sent at once (eager), though no receive is posted and its receiver
 * computes; a longer message is sent by rendezvous, and so waits until the receiver answers. csend of neither
 * waits for a receive to be posted.
 * simulator only: of times
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 */
#include "rule.h"

static volatile double x = 1;

int main(void)
{
    static char buf[101];
    double took[2] = {0, 0};
    gsync();
    for (int i = 0; i < 2; i++) {
        gsync();
        if (mynode() == 0) {
            double since = dclock();
            csend(1, buf, 100 + i, 1, 0);
            took[i] = dclock() - since;
        } else {
            for (int j = 0; j < 1000000; j++)
                x = x * 1.0000001;
            crecv(1, buf, sizeof buf);
        }
        gsync();
    }
    rule("100 bytes leave within 0.2 ms", took[0] < 0.0002);
    rule("101 bytes take an answer", mynode() != 0 || took[1] > took[0]);
    rule("which needs no receive", took[1] < 0.01);
    return 0;
}
