/* isend_overwritten_fault.c - main changes a buffer before msgwait has said that its isend is complete: the
 * message may hold the old row or the new one.
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
        row[0] = sum; /* RACE */
        msgwait(id);
        printf("%g\n", row[0]);
    } else {
        crecv(ROW, row, sizeof row);
    }
    return 0;
}
