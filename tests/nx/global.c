/* Global operations give every node the same result, on any number of nodes.
 * run: -m ipsc860 -n 1
 * run: -m ipsc860 -n 2
 * run: -m ipsc860 -n 3
 * run: -m ipsc860 -n 8
 * run: -m delta -n 33
 */
#include <nx.h>
#include <stdio.h>

int main(void)
{
    long n = numnodes(), me = mynode(), iv[2], iw[2], wrong = 0;
    double dv[3], dw[3];
    int round;
    for (round = 0; round < 3; round++) {
        dv[0] = (double)me, dv[1] = 1, dv[2] = -0.5 * (double)me;
        gdsum(dv, 3, dw);
        wrong += dv[0] != (double)(n * (n - 1) / 2) || dv[1] != (double)n ||
                 dv[2] != -0.25 * (double)(n * (n - 1));
        dv[0] = (double)(me * me), gdhigh(dv, 1, dw), wrong += dv[0] != (double)((n - 1) * (n - 1));
        dv[0] = (double)me + 2, gdlow(dv, 1, dw), wrong += dv[0] != 2;
        iv[0] = me, iv[1] = -me;
        gisum(iv, 2, iw), wrong += iv[0] != n * (n - 1) / 2 || iv[1] != -iv[0];
        iv[0] = me, iv[1] = -me;
        gihigh(iv, 2, iw), wrong += iv[0] != n - 1 || iv[1] != 0;
        iv[0] = me, iv[1] = -me;
        gilow(iv, 2, iw), wrong += iv[0] != 0 || iv[1] != 1 - n;
        gsync();
    }
    wrong += ginv(gray(me)) != me;
    gisum(&wrong, 1, iw);
    if (me == 0)
        printf("%ld wrong\n", wrong);
    return 0;
}
