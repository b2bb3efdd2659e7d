/* masktrap(1) holds handlers back, in computing and in calls that wait; masktrap(0) lets them run, held ones
 * at once, in the order in which their messages came. It returns the state before.
 * run: all
 */
#include "rule.h"

static char box[3][8];
static volatile int handled, order;

static void handler(long type, long count, long node, long pid)
{
    long before = masktrap(1);
    order = order * 10 + (int)type;
    handled++;
    masktrap(before);
    (void)count, (void)node, (void)pid;
}

int main(void)
{
    rule("handlers are let run at first", masktrap(1) == 0);
    rule("it returns the state before", masktrap(1) == 1 && masktrap(0) == 1 && masktrap(0) == 0);
    for (long type = 1; type <= 3; type++)
        hrecv(type, box[type - 1], 8, handler);
    masktrap(1);
    gsync();
    csend(2, "b", 2, next_node(), 0);
    csend(1, "a", 2, next_node(), 0);
    csend(3, "c", 2, next_node(), 0);
    csend(4, "d", 2, next_node(), 0);
    crecv(4, box[0], 8);
    gsync();
    rule("held back in calls that wait", handled == 0);
    for (double until = dclock() + 0.005; dclock() < until;)
        flick();
    rule("and in those that do not", handled == 0);
    rule("masktrap(0) runs them at once", masktrap(0) == 1 && handled == 3);
    rule("in the order of their messages", order == 213);
    return 0;
}
