/* text.c - the handler writes a text that main copies: the copy may begin with one text and end with
 * another. In the usual run the handler comes long after.
 * With CORRECT: main copies it while the handler is masked. What main prints afterwards is its own copy.
 * variable: status */
#include <stdio.h>
#include <string.h>
#include "nx.h"

enum { STATUS = 5, END = 6 };
static char status[40] = "starting", next[40];

static void on_status(long type, long count, long node, long pid)
{
    memcpy(status, next, count); /* RACE */
    csend(END, NULL, 0, mynode(), 0);
}

int main(void)
{
    char copy[40];

    if (mynode() == 0) {
        hrecv(STATUS, next, sizeof next, on_status);
#ifdef CORRECT
        masktrap(1);
        strcpy(copy, status);
        masktrap(0);
#else
        strcpy(copy, status); /* RACE */
#endif
        crecv(END, NULL, 0);
        printf("%s, then %s\n", copy, status);
    } else {
        csend(STATUS, "computing", sizeof "computing", 0, 0);
    }
    return 0;
}
