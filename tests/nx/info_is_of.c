/* infocount(), infonode(), infotype() and infopid() are of the last message received, probed for with
 * success, or waited for; probes that find nothing and sends leave them alone. info[8] of the x calls has
 * type, length, node, ptype.
 * run: all
 */
#include "rule.h"

static char buf[100];

static int is(long type, long count)
{
    return infotype() == type && infocount() == count && infonode() == last_node() && infopid() == 3;
}

int main(void)
{
    long to = next_node(), id, other, info[8] = {0, 0, 0, 0, 11, 12, 13, 14};
    setptype(3);
    for (long type = 1; type <= 9; type++)
        csend(type, buf, 10 * type, to, 3);
    crecv(1, buf, 100);
    rule("crecv", is(1, 10));
    cprobe(3);
    rule("cprobe", is(3, 30));
    rule("an iprobe that finds nothing", iprobe(77) == 0 && is(3, 30));
    rule("an iprobe that finds something", iprobe(2) == 1 && is(2, 20));
    id = irecv(4, buf, 100), other = irecv(5, buf, 100);
    rule("posting", is(2, 20));
    msgwait(other);
    rule("msgwait", is(5, 50));
    while (!msgdone(id))
        ;
    rule("msgdone", is(4, 40));
    msgwait(isend(20, buf, 1, to, 3));
    csend(20, buf, 1, to, 3);
    rule("sends", is(4, 40));
    crecvx(6, buf, 100, last_node(), 3, info);
    rule("info of crecvx", info[0] == 6 && info[1] == 60 && info[2] == last_node() && info[3] == 3);
    rule("its other four", info[4] == 11 && info[5] == 12 && info[6] == 13 && info[7] == 14);
    rule("infocount() after it", is(6, 60));
    iprobex(7, -1, -1, msginfo);
    rule("iprobex", msginfo[0] == 7 && msginfo[1] == 70);
    id = irecvx(-1, buf, 100, last_node(), 3, info);
    msgwait(id);
    rule("irecvx takes the first of any type", info[0] == 2 && info[1] == 20);
    return 0;
}
