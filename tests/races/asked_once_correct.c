/* asked_once_correct.c - main asks msgdone whether its receive is complete until the answer is 1, and then
 * clears the buffer for later use. */
#include <stdio.h>
#include <string.h>
#include "nx.h"

enum { DATA = 5 };
static char buffer[200], out[200];

int main(void)
{
    long id;

    if (mynode() == 0) {
        id = irecv(DATA, buffer, sizeof buffer);
        while (!msgdone(id))
            ;
        memset(buffer, 0, sizeof buffer);
        printf("%d\n", buffer[0]);
    } else {
        for (id = 0; id < 100; id++)
            flick();
        csend(DATA, out, sizeof out, 0, 0);
    }
    return 0;
}
