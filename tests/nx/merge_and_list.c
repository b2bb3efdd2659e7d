/* msgmerge makes one id of several, complete when all are; gsendx sends to the nodes of a list.
 * run: all
 */
#include "rule.h"

int main(void)
{
    long nodes = numnodes(), me = mynode(), list[70], x = me, in[70], id = -1, sum = 0;
    for (long i = 0; i < nodes; i++)
        list[i] = nodes - 1 - i;
    for (long i = 0; i < nodes; i++)
        id = msgmerge(id, irecv(1, &in[i], sizeof in[i]));
    gsendx(1, &x, sizeof x, list, nodes);
    msgwait(id);
    for (long i = 0; i < nodes; i++)
        sum += in[i];
    rule("from all, under one id", sum == nodes * (nodes - 1) / 2);
    id = msgmerge(irecv(2, &in[0], sizeof x), irecv(3, &in[1], sizeof x));
    csend(3, &x, sizeof x, me, 0);
    rule("not complete when one is", msgdone(id) == 0 && iprobe(3) == 0);
    csend(2, &x, sizeof x, me, 0);
    while (!msgdone(id))
        ;
    rule("but when both are", in[0] == me && in[1] == me);
    return 0;
}
