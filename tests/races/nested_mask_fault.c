/* nested_mask_fault.c - a function masks handlers, and then lets them run although its caller had masked
 * them already: what the caller does afterwards is unprotected.
 * variable: bytes */
#include <stdio.h>
#include "nx.h"

enum { NOTE = 5, ENOUGH = 6, NOTES = 3 };
static long entries, bytes, note, notes;

static void log_entry(void)
{
    masktrap(1);

    entries++;
    masktrap(0);
}

static void log_bytes(long n)
{

    masktrap(1);
    log_entry();
    bytes += n; /* RACE */
    masktrap(0);
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
