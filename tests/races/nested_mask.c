/* nested_mask.c - a function masks handlers, and then lets them run although its caller had masked them
 * already: what the caller does afterwards is unprotected.
 * With CORRECT: a function masks handlers, and then restores what was before: for a caller that had
 * masked them, they stay masked.
 * variable: bytes */
#include <stdio.h>
#include "nx.h"

enum { NOTE = 5, ENOUGH = 6, NOTES = 3 };
static long entries, bytes, note, notes;

static void log_entry(void)
{
#ifdef CORRECT
    long before = masktrap(1);
#else
    masktrap(1);
#endif

    entries++;
#ifdef CORRECT
    masktrap(before);
#else
    masktrap(0);
#endif
}

static void log_bytes(long n)
{
#ifdef CORRECT
    long before = masktrap(1);
#else
    masktrap(1);
#endif

    log_entry();
    bytes += n; /* RACE */
#ifdef CORRECT
    masktrap(before);
#else
    masktrap(0);
#endif
}

static void on_note(long type, long count, long node, long pid)
{
    entries++;
    bytes += note; /* RACE */
    if (++notes < NOTES)
        hrecv(NOTE, &note, sizeof note, on_note);
    else
        csend(ENOUGH, NULL, 0, mynode(), 0);
}

int main(void)
{
    long i;

    if (mynode() == 0) {
        hrecv(NOTE, &note, sizeof note, on_note);
        for (i = 1; i <= 10; i++)
            log_bytes(i);
        crecv(ENOUGH, NULL, 0);
        printf("%ld entries, %ld bytes\n", entries, bytes);
    } else {
        for (i = 100; i < 100 + NOTES; i++)
            csend(NOTE, &i, sizeof i, 0, 0);
    }
    return 0;
}
