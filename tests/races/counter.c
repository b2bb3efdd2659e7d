/* counter.c - main and the handler count in one variable. Main does so without masktrap: the handler may
 * run between main's load and its store, and its count is lost.
 * With CORRECT: main masks the handler between its load and its store, and after ENOUGH the handler does
 * not run any more.
 * variable: done */
#include <stdio.h>
#include "nx.h"

enum { JOB = 5, ENOUGH = 6, JOBS = 8 };
static long done, handled;

static void on_job(long type, long count, long node, long pid)
{
    done++; /* RACE */
    if (++handled == JOBS)
        csend(ENOUGH, NULL, 0, mynode(), 0);
    else
        hrecv(JOB, NULL, 0, on_job);
}

int main(void)
{
    int i;

    if (mynode() == 0) {
        hrecv(JOB, NULL, 0, on_job);
        for (i = 0; i < JOBS; i++) {
            flick();
#ifdef CORRECT
            masktrap(1);
            done++;
            masktrap(0);
#else
            done++; /* RACE */
#endif
        }
        crecv(ENOUGH, NULL, 0);
        printf("%ld jobs\n", done);
    } else {
        for (i = 0; i < JOBS; i++)
            csend(JOB, NULL, 0, 0, 0);
    }
    return 0;
}
