/* The Paragon's x calls select the sending node and its ptype, and put what they find into info; info's last
 * four longs stay as they are.
 * run: -m ipsc860 -n 3
 * run: -m ipsc860 -n 8
 * run: -m delta -n 33
 * run: -m paragon -n 8
 */
#include <nx.h>
#include <stdio.h>

static long wrong;
static volatile long handled;

static void sent(long type, long count, long node, long ptype, long param)
{
    wrong += type != 4 || count != mynode() || node != 0 || ptype != 0 || param != 6;
    handled++;
}

static void received(long type, long count, long node, long ptype, long param)
{
    wrong += type != 4 || count != node || ptype != node + 100 || param != -5;
    handled++;
}

/* Messages come in in some order; they are received in the order of the nodes. */
static void receive(void)
{
    long info[8] = {0}, i, id, n = numnodes();
    static char buf[100];
    info[4] = 77;
    for (i = n - 1; i > 0; i--) {
        crecvx(1, buf, sizeof buf, i, -1, info);
        wrong += info[0] != 1 || info[1] != i || info[2] != i || info[3] != i + 100 || info[4] != 77;
        wrong += infonode() != i || infoptype() != i + 100;
    }
    for (i = 1; i < n; i++) {
        cprobex(-1, -1, i + 100, msginfo);
        wrong += msginfo[2] != i;
        wrong += iprobex(2, i, i + 99, info) != 0 || iprobex(2, i, i + 100, info) != 1 || info[1] != i + 1;
        id = irecvx(2, buf, sizeof buf, i, i + 100, info);
        msgwait(id);
        wrong += info[0] != 2 || info[1] != i + 1;
    }
    for (i = 1; i < n; i++)
        hrecvx(4, buf, sizeof buf, i, -1, received, -5);
    csend(3, buf, 0, -1, 0);
    while (handled < n - 1)
        flick();
}

int main(void)
{
    static char buf[100];
    long me = mynode(), work;
    if (me == 0) {
        receive();
    } else {
        setptype(me + 100);
        wrong += myptype() != me + 100 || mypid() != me + 100;
        csend(1, buf, me, 0, 0);
        csend(2, buf, me + 1, 0, 0);
        crecv(3, buf, 0);
        hsendx(4, buf, me, 0, 0, sent, 6);
        while (!handled)
            flick();
    }
    gisum(&wrong, 1, &work);
    if (me == 0)
        printf("%ld wrong\n", wrong);
    return 0;
}
