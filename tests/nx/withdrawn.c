/* msgcancel of receives that have got their messages already: another that is posted for such messages gets
 * one; later receives get them in the order in which they were sent.
 * run: all
 * run: -m paragon -n 4
 */
#include <limits.h>
#include "rule.h"

enum { MOST = 50000, TYPE = 5, HANDLED, ALL_SENT, OTHER };

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

/* Three messages have come for receives, and another for none. The receives are withdrawn in some order;
 * messages of another type have come among them. */
static int in_order(const long length[4], const int withdrawn[3])
{
    static char got[3][MOST];
    long id[3];
    int good = 1;
    for (int i = 0; i < 3; i++)
        id[i] = irecv(TYPE, got[i], MOST);
    for (int i = 0; i < 4; i++) {
        send(TYPE, (char)i, length[i]);
        send(OTHER, (char)i, 1);
    }
    wait_for_all();
    for (int i = 0; i < 3; i++)
        msgcancel(id[withdrawn[i]]);
    for (int i = 0; i < 4; i++) {
        crecv(i % 2 ? TYPE : INT_MIN + (1 << TYPE), in[0], MOST);
        good &= in[0][0] == i;
    }
    for (int i = 0; i < 4; i++) {
        crecv(OTHER, in[0], MOST);
        good &= in[0][0] == i;
    }
    gsync();
    return good;
}

static void check_order(void)
{
    static const long size[] = {4, MOST, 2000};
    static const int orders[][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    int good = 1;
    for (int i = 0; i < 27; i++)
        for (int o = 0; o < 6; o++)
            good &= in_order((const long[]){size[i % 3], size[i / 3 % 3], size[i / 9], 4}, orders[o]);
    rule("they come again in the order in which they were sent", good);
}

int main(void)
{
    check(4);
    check(MOST);
    check_order();
    return 0;
}
