/* places.c - for race_reports.sh: a handler counts in a structure that main uses in several lines. */
#include <stddef.h>
#include "nx.h"

enum { ADD = 1 };
static struct {
    long adds, last;
} count;
static long other;

static void on_add(long type, long bytes, long node, long pid)
{
    (void)type, (void)bytes, (void)pid;
    count.adds++;
    count.last = node;
    other++;
}

int main(void)
{
    if (mynode() == 0)
        hrecv(ADD, NULL, 0, on_add);
    else
        csend(ADD, NULL, 0, 0, 0);
    count.adds = 0;
    count.last = 0;
    other += count.adds;
    gsync();
    return 0;
}
