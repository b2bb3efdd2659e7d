/* A node that has ended stays so until somebody has waited for it: waitall waits for one or for all others;
 * each end is told of once.
 * run: all
 */
#include "rule.h"

int main(void)
{
    long nodes = numnodes(), x;
    if (mynode() != 0) {
        crecv(1, &x, sizeof x);
        return 0;
    }
    for (long i = nodes - 1; i > 0; i--) {
        csend(1, &i, sizeof i, i, 0);
        if (i % 2)
            waitall(i, 0);
    }
    waitall(-1, -1);
    printf("all have ended: %s\n", _waitone(-1, -1, 0, 0, 0) == -1 && errno == EQNOPROC ? "yes" : "NO");
    printf("waiting again for them returns: %s\n", _waitall(-1, -1) == 0 ? "yes" : "NO");
    return 0;
}
