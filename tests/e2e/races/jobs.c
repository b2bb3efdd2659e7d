/* jobs.c - for race_reports.sh: node 0 counts jobs in a handler and in main, with and without masktrap; fills
 * a buffer that is under way; and waits by a flag that the handler sets. The others send jobs. */
#include <stdio.h>
#include "nx.h"

enum { JOB = 1, LAST = 2, BLOCK = 3, JOBS = 5, N = 100 };
static long done, safe, last;
static int ended;
static double block[N];

static void count(void)
{
    done++;
    safe++;
}

static void on_job(long type, long bytes, long node, long pid)
{
    (void)type, (void)bytes, (void)node, (void)pid;
    count();
    hrecv(JOB, NULL, 0, on_job);
}

static void on_last(long type, long bytes, long node, long pid)
{
    (void)type, (void)bytes, (void)node, (void)pid;
    last = safe;
    ended = 1;
}

static void serve(void)
{
    long i, id;

    hrecv(JOB, NULL, 0, on_job);
    for (i = 0; i < JOBS; i++) {
        done++;
        masktrap(1);
        safe++;
        masktrap(0);
    }
    id = isend(BLOCK, block, sizeof block, 1, 0);
    block[0] = 1;
    msgwait(id);
    hrecv(LAST, NULL, 0, on_last);
    csend(LAST, NULL, 0, mynode(), 0);
    while (!ended)
        flick();
    printf("%d\n", last >= JOBS);
}

int main(void)
{
    long i;

    if (mynode() == 0) {
        serve();
    } else {
        for (i = 0; i < JOBS; i++)
            csend(JOB, NULL, 0, 0, 0);
        if (mynode() == 1)
            crecv(BLOCK, block, sizeof block);
    }
    return 0;
}
