/* isend_overwritten.c - main changes a buffer before msgwait has said that its isend is complete: the
 * message may hold the old row or the new one.
 * With CORRECT: main changes a buffer when msgwait has said that its isend is complete; reading the
 * buffer meanwhile does no harm.
 * variable: row */
#include <stdio.h>
#include "nx.h"

enum { ROW = 5, N = 2000 };
static float row[N];

int main(void)
{
    float sum = 0;
    long id;
    int i;

    if (mynode() == 0) {
        for (i = 0; i < N; i++)
            row[i] = i;
        id = isend(ROW, row, sizeof row, 1, 0); /* RACE */
        for (i = 0; i < N; i++)
            sum += row[i];
#ifdef CORRECT
        msgwait(id);
        row[0] = sum;
#else
        row[0] = sum; /* RACE */
        msgwait(id);
#endif
        printf("%g\n", row[0]);
    } else {
        crecv(ROW, row, sizeof row);
    }
    return 0;
}
