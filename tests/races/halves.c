/* halves.c - main reads a value of two words that the handler sets: it may read one word before the
 * handler runs and the other after. In the usual run the handler runs while main waits in crecv.
 * With CORRECT: main reads both while the handler is masked: they belong together. Before and after that
 * it keeps to its copy.
 * variable: stamp */
#include <stdio.h>
#include "nx.h"

enum { TICK = 5, GO = 6, END = 7 };
static struct stamp {
    long seconds, micros;
} stamp = {1, 999999};
static long ticks;

static void on_tick(long type, long count, long node, long pid)
{
    stamp.seconds = ticks / 1000000, stamp.micros = ticks % 1000000; /* RACE */
}

int main(void)
{
    long first, last, time = 2000001;

    if (mynode() == 0) {
        hrecv(TICK, &ticks, sizeof ticks, on_tick);
#ifdef CORRECT
        masktrap(1);
        first = stamp.seconds * 1000000 + stamp.micros;
        masktrap(0);
#else
        first = stamp.seconds * 1000000 + stamp.micros; /* RACE */
#endif
        csend(GO, NULL, 0, 1, 0);
        crecv(END, NULL, 0);
        masktrap(1);
        last = stamp.seconds * 1000000 + stamp.micros;
        masktrap(0);
        printf("never backwards: %s\n", first <= last ? "yes" : "no");
    } else {
        csend(TICK, &time, sizeof time, 0, 0);
        crecv(GO, NULL, 0);
        csend(END, NULL, 0, 0, 0);
    }
    return 0;
}
