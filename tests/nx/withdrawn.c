/* msgcancel of a receive that has got its message already: another that is posted for such messages gets it.
 * run: all
 * run: -m paragon -n 4
 */
#include "rule.h"

enum { MOST = 50000, TYPE = 5, HANDLED, ALL_SENT };

static char out[MOST], in[2][MOST];
static volatile char handled;

static void send(long type, char first, long length)
{
    out[0] = first;
    csend(type, out, length, next_node(), 0);
}

/* All that the other node has sent is here, or on its way. */
static void wait_for_all(void)
{
    send(ALL_SENT, 0, 0);
    crecv(ALL_SENT, NULL, 0);
}

static void handler(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    handled = in[1][0];
}

static void check(long length)
{
    long id = irecv(TYPE, in[0], MOST), other = irecv(TYPE, in[1], MOST);
    send(TYPE, 1, length);
    wait_for_all();
    msgcancel(id);
    msgwait(other);
    rule("another receive gets it", in[1][0] == 1);

    handled = 0;
    id = irecv(HANDLED, in[0], MOST);
    hrecv(HANDLED, in[1], MOST, handler);
    send(HANDLED, 2, length);
    wait_for_all();
    msgcancel(id);
    while (!handled)
        flick();
    rule("a handler gets it", handled == 2);
}

int main(void)
{
    check(4);
    check(MOST);
    return 0;
}
