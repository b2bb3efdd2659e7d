/* host.c - for race_reports.sh: a host program whose handler counts what main counts, too. */
#include <stddef.h>
#include "nx.h"

static long count;

static void on_any(long type, long bytes, long node, long pid)
{
    (void)type, (void)bytes, (void)node, (void)pid;
    count++;
}

int main(void)
{
    int i;

    hrecv(1, NULL, 0, on_any);
    csend(1, NULL, 0, myhost(), 0);
    count++;
    for (i = 0; i < 1000; i++)
        flick();
    return 0;
}
