/* stopped_early.c - for race_reports.sh: node 0 fails while node 1 goes through a table that its handler has filled. */
#include <stddef.h>
#include <unistd.h>
#include "nx.h"

enum { FILL = 1, WORDS = 20000, BEFORE = 5 };
static int table[WORDS];

static void on_fill(long type, long bytes, long node, long pid)
{
    (void)type, (void)bytes, (void)node, (void)pid;
    for (int i = 0; i < WORDS; i++)
        table[i] = i;
}

int main(void)
{
    if (mynode() == 1)
        hrecv(FILL, NULL, 0, on_fill);
    gsync();
    if (mynode() == 0) {
        csend(FILL, NULL, 0, 1, 0);
        usleep(1000000);
        csend(FILL, NULL, 0, 99, 0); /* there is no such node */
    }
    usleep(900000);
    for (int i = 0; i < WORDS; i++) {
        table[i] = 0;
        if (i == BEFORE - 1)
            usleep(99900);
    }
    gsync();
    return 0;
}
