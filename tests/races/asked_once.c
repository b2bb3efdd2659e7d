/* asked_once.c - main asks msgdone whether its receive is complete, does not look at the answer, and
 * clears the buffer for later use.
 * With CORRECT: main asks msgdone until the answer is 1, and then clears the buffer for later use.
 * variable: buffer */
#include <stdio.h>
#include <string.h>
#include "nx.h"

enum { DATA = 5 };
static char buffer[200], out[200];

int main(void)
{
    long id;

    if (mynode() == 0) {
        id = irecv(DATA, buffer, sizeof buffer); /* RACE */
#ifndef CORRECT
        msgdone(id);
        memset(buffer, 0, sizeof buffer); /* RACE */
#endif
        while (!msgdone(id))
            ;
#ifdef CORRECT
        memset(buffer, 0, sizeof buffer);
#endif
        printf("%d\n", buffer[0]);
    } else {
        for (id = 0; id < 100; id++)
            flick();
        csend(DATA, out, sizeof out, 0, 0);
    }
    return 0;
}
