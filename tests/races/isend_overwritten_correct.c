/* isend_overwritten_correct.c - main changes a buffer when msgwait has said that its isend is complete;
 * reading the buffer meanwhile does no harm. */
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
        id = isend(ROW, row, sizeof row, 1, 0);
        for (i = 0; i < N; i++)
            sum += row[i];
        msgwait(id);
        row[0] = sum;
        printf("%g\n", row[0]);
    } else {
        crecv(ROW, row, sizeof row);
    }
    return 0;
}
