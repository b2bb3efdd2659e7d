/* Tens of thousands of messages wait until somebody receives them, each way, in the order sent.
 * run: all
 */
#include "rule.h"

enum { MESSAGES = 25000 };

int main(void)
{
    long me = mynode(), partner = numnodes() - 1 - me;
    int good = 1, in = -1;
    if (me == 0 || partner == 0)
        for (int i = 0; i < MESSAGES; i++)
            csend(5, &i, sizeof i, partner, 0);
    gsync();
    if (me == 0 || partner == 0)
        for (int i = 0; i < MESSAGES; i++) {
            crecv(5, &in, sizeof in);
            good = good && in == i;
        }
    rule("all are there, in order", good);
    rule("and no more", iprobe(-1) == 0);
    return 0;
}
