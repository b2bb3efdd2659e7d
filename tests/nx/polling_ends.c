/* Time passes in loops that only poll - iprobe, msgdone, flick, mclock, dclock -, so that the awaited message
 * comes.
 * run: all
 */
#include "rule.h"

static volatile int handled;

static void handler(long type, long count, long node, long pid)
{
    handled = 1;
    (void)type, (void)count, (void)node, (void)pid;
}

int main(void)
{
    char in[4], out[4] = "abc";
    long id;
    csend(1, out, 4, next_node(), 0);
    while (!iprobe(1))
        ;
    rule("iprobe", infocount() == 4 && infonode() == last_node());
    crecv(1, in, 4);
    id = irecv(2, in, 4);
    csend(2, out, 3, next_node(), 0);
    while (!msgdone(id))
        ;
    rule("msgdone", infocount() == 3);
    hrecv(3, in, 4, handler);
    csend(3, out, 4, next_node(), 0);
    while (!handled)
        flick();
    rule("flick", 1);
    unsigned long ms = mclock();
    while (mclock() < ms + 3)
        ;
    rule("mclock", 1);
    double s = dclock();
    while (dclock() < s + 0.003)
        ;
    rule("dclock", 1);
    return 0;
}
