/* pairs.c - for race_reports.sh: the even nodes have a handler that races with main in the same two lines;
 * the odd ones send. */
#include "nx.h"

enum { ADD = 1 };
static long sum, value;

static void on_add(long type, long bytes, long node, long pid)
{
    (void)type, (void)bytes, (void)node, (void)pid;
    sum += value;
}

int main(void)
{
    long i;

    if (mynode() % 2 == 0)
        hrecv(ADD, &value, sizeof value, on_add);
    else
        csend(ADD, &i, sizeof i, mynode() - 1, 0);
    for (i = 0; i < 3; i++)
        sum++;
    gsync();
    return 0;
}
