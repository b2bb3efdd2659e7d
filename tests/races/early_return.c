/* early_return.c - on its early return, take() lets handlers run and then counts that it found nothing;
 * the handler reads and clears this count.
 * With CORRECT: on its early return, too, take() counts before it lets handlers run.
 * variable: misses */
#include <stdio.h>
#include "nx.h"

enum { REPORT = 5, REPORTED = 6, END = 7 };
static long queue[4] = {3, 5, 7, 9}, left = 4, misses;

static void on_report(long type, long count, long node, long pid)
{
    long answer = misses;

    misses = 0; /* RACE */
    csend(REPORTED, &answer, sizeof answer, node, 0);
}

static long take(void)
{
    long item;

    masktrap(1);
    if (left == 0) {
#ifdef CORRECT
        misses++;
        masktrap(0);
#else
        masktrap(0);
        misses++; /* RACE */
#endif
        return 0;
    }
    item = queue[--left];
    masktrap(0);
    return item;
}

int main(void)
{
    long i, sum = 0, before;

    if (mynode() == 0) {
        hrecv(REPORT, NULL, 0, on_report);
        for (i = 0; i < 7; i++)
            sum += take();
        crecv(END, &before, sizeof before);
        printf("sum %ld, %ld misses\n", sum, before + misses);
    } else {
        csendrecv(REPORT, NULL, 0, 0, 0, REPORTED, &before, sizeof before);
        csend(END, &before, sizeof before, 0, 0);
    }
    return 0;
}
