/* A message that comes to a computing program enters OSF/1's kernel (entry_us), unless program or system are
 * in it.
 * simulator only: times
 * run: -m paragon -n 3
 */
#include "rule.h"

enum { TYPE = 1, OTHER, DONE };
static const double ENTRY = 65.5, RECEIVE = 48; /* us: machines/paragon.cfg */
static double start;

static void compute_until(double us)
{
    while ((dclock() - start) * 1e6 < us)
        ;
}

/* Node 0 works, which takes it so many us in all. Nodes 1 and 2 send it a message at these times; below 0:
 * none. */
static double takes(void (*work)(void), double first, double second)
{
    double at = mynode() == 1 ? first : second, took = 0;
    gsync();
    start = dclock();
    if (mynode() == 0) {
        work();
        took = (dclock() - start) * 1e6;
        csend(DONE, NULL, 0, -1, 0);
        for (int expected = (first >= 0) + (second >= 0); expected; expected--)
            crecv(TYPE, NULL, 0);
    } else {
        if (at >= 0)
            compute_until(at), csend(TYPE, NULL, 0, 0, 0);
        crecv(DONE, NULL, 0);
    }
    return took;
}

static void computes(void)
{
    volatile double sum = 0;
    for (int i = 1; i <= 3000; i++)
        sum += 1.0 / i;
}

/* The message is sent in 52 us from 500 us on, or a little later: it takes as long as a call of dclock. */
static void sends(void)
{
    compute_until(500);
    csend(OTHER, NULL, 0, mynode(), 0);
    crecv(OTHER, NULL, 0);
}

/* Is that what the messages add to the work? */
static void adds(const char *text, void (*work)(void), double first, double second, double expected)
{
    double us = -takes(work, -1, -1) + takes(work, first, second);
    int is = mynode() || (us > expected - 0.1 && us < expected + 0.1);
    if (!is)
        printf("%.1f us, not %.1f\n", us, expected);
    rule(text, is);
}

int main(void)
{
    adds("a program that computes: the kernel is entered", computes, 500, -1, RECEIVE + ENTRY);
    adds("two messages that come together: it is entered once", computes, 500, 510, 2 * RECEIVE + ENTRY);
    adds("one after the other: twice", computes, 500, 900, 2 * (RECEIVE + ENTRY));
    adds("a program that sends is in it", sends, 480, -1, RECEIVE);
    return 0;
}
