/* gsendx sends to the nodes listed, in order; a node may be listed twice, and the sender itself.
 * run: -m ipsc860 -n 3
 * run: -m delta -n 8
 */
#include <nx.h>
#include <stdio.h>

int main(void)
{
    long list[] = {2, 0, 1, 2}, got = 0, total[8] = {0}, work[8];
    char buf[8];
    if (mynode() == 0)
        gsendx(9, "to you", 7, list, 4);
    if (mynode() < 3)
        crecv(9, buf, sizeof buf), got++;
    if (mynode() == 2)
        crecv(9, buf, sizeof buf), got++;
    gsync();
    got += iprobe(9);
    total[mynode()] = got;
    gisum(total, 8, work);
    if (mynode() == 0)
        printf("%ld %ld %ld %ld\n", total[0], total[1], total[2], total[3]);
    return 0;
}
