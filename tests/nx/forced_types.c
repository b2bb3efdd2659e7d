/* A message of a force type is sent without rendezvous, and dropped if no receive that selects it is posted;
 * no system buffer holds it. A posted receive takes it at any length.
 * run: all
 */
#include <string.h>
#include "rule.h"

enum { FORCED = 1 << 30, LONG = 30000 };
static char out[LONG], in[LONG];
static volatile int handled;

static void handler(long type, long count, long node, long pid)
{
    handled = type == (FORCED | 3) && count == 5;
    (void)node, (void)pid;
}

int main(void)
{
    long id, to = next_node();
    memset(out, 'x', sizeof out);
    csend(FORCED | 1, out, 10, to, 0);
    csend(FORCED | 1, out, LONG, to, 0);
    csend(1, out, 0, to, 0);
    crecv(1, in, 0);
    gsync();
    rule("dropped when nothing is posted", iprobe(-1) == 0);
    id = irecv(FORCED | 1, in, sizeof in);
    gsync();
    csend(FORCED | 2, out, 20, to, 0); /* not the one selected */
    csend(FORCED | 1, out, LONG, to, 0);
    msgwait(id);
    rule("received when posted, at any length",
         infocount() == LONG && infotype() == (FORCED | 1) && in[LONG - 1] == 'x');
    rule("dropped when another is posted", iprobe(-1) == 0);
    hrecv(FORCED | 3, in, sizeof in, handler);
    gsync();
    csend(FORCED | 3, out, 5, to, 0);
    while (!handled)
        flick();
    rule("received by a handler", handled);
    return 0;
}
