/* livelock.c - programs that run and come no further, and some that look like it; the argument says which. */
#include <stdlib.h>
#include <string.h>
#include <nx.h>

static char buf[8];
static volatile long handled;
static volatile double x;

static void on_message(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    handled++;
    hrecv(5, buf, 8, on_message);
}

static void compute(long n)
{
    for (; n > 0; n--)
        x += 1;
}

static void probe(void)
{
    while (!iprobe(7)) /* line of iprobe */
        compute(1);
}

static void probe_two(void)
{
    while (!iprobe(7) && !iprobex(8, 1, 0, NULL)) /* line of two */
        compute(1);
}

static void ask(void)
{
    long id = irecv(11, buf, 8);

    while (!msgdone(id)) /* line of msgdone */
        compute(1);
}

static void give_away(void)
{
    hrecv(5, buf, 8, on_message);
    while (!handled)
        flick(); /* line of flick */
}

/* All others flood node 0, which computes. */
static void flood(long each)
{
    if (mynode() == 0)
        hrecv(5, buf, 8, on_message);
    gsync();
    if (mynode() == 0)
        compute(500000);
    else
        for (; each > 0; each--)
            csend(5, buf, 8, 0, 0);
    gsync();
}

/* Node 0 polls for each message of the others, and gets it in the end. */
static void served(void)
{
    long i;

    for (i = 0; mynode() == 0 && i < 20 * (numnodes() - 1); i++) {
        while (!iprobe(7))
            compute(1);
        crecv(7, buf, 8);
    }
    for (i = 0; mynode() != 0 && i < 20; i++) {
        compute(100000);
        csend(7, buf, 8, 0, 0);
    }
}

/* Looks for an order to stop now and then, which nobody gives, and comes to its end. */
static void looks(void)
{
    int i;

    for (i = 0; i < 2000 && !iprobe(7); i++)
        compute(2000);
}

/* Gives the processor away until some time has passed, and ends. */
static void naps(void)
{
    for (int i = 0; i < 5000; i++)
        flick();
}

int main(int argc, char **argv)
{
    const char *what = argv[argc - 1];

    if (!strcmp(what, "flood"))
        flood(2000);
    else if (!strcmp(what, "served"))
        served();
    else if (!strcmp(what, "looks"))
        looks();
    else if (!strcmp(what, "naps"))
        naps();
    else if (mynode() == 0)
        crecv(9, buf, 8);
    else if (!strcmp(what, "iprobe"))
        probe();
    else if (!strcmp(what, "two"))
        probe_two();
    else if (!strcmp(what, "msgdone"))
        ask();
    else if (!strcmp(what, "flick"))
        give_away();
    return 0;
}
