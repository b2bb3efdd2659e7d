/* A message may have no bytes; buffers may then be null pointers. It is sent, probed for, received and
 * handled as any other.
 * run: all
 */
#include "rule.h"

static volatile int handled;

static void handler(long type, long count, long node, long pid)
{
    handled = type == 4 && count == 0;
    (void)node, (void)pid;
}

int main(void)
{
    long to = next_node(), id, info[8];
    csend(0, 0, 0, to, 0);
    crecv(0, 0, 0);
    rule("csend and crecv, of type 0", infocount() == 0 && infotype() == 0 && infonode() == last_node());
    id = irecv(1, 0, 0);
    msgwait(isend(1, 0, 0, to, 0));
    msgwait(id);
    rule("isend and irecv", infocount() == 0 && infotype() == 1);
    csend(2, 0, 0, to, 0);
    cprobe(2);
    rule("cprobe and iprobe", infocount() == 0 && iprobe(2) == 1);
    crecvx(2, 0, 0, last_node(), -1, info);
    rule("crecvx", info[0] == 2 && info[1] == 0 && info[2] == last_node());
    rule("csendrecv", csendrecv(3, 0, 0, mynode(), 0, 3, 0, 0) == 0);
    hrecv(4, 0, 0, handler);
    gsync();
    csend(4, 0, 0, to, 0);
    while (!handled)
        flick();
    rule("hrecv", handled);
    return 0;
}
