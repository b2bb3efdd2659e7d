/* merged_correct.c - main posts two receives and waits for both, by one merged message id, before it uses
 * the buffers. */
#include <stdio.h>
#include "nx.h"

enum { LEFT = 5, RIGHT = 6, N = 8 };
static double left[N], right[N];

int main(void)
{
    long a, b;
    int i;

    if (mynode() == 0) {
        a = irecv(LEFT, left, sizeof left);
        b = irecv(RIGHT, right, sizeof right);
        a = msgmerge(a, b);
        msgwait(a);
        for (i = 0; i < N; i++)
            left[i] += right[i];
        printf("%g\n", left[0]);
    } else {
        for (i = 0; i < N; i++)
            left[i] = right[i] = i;
        csend(RIGHT, right, sizeof right, 0, 0);
        csend(LEFT, left, sizeof left, 0, 0);
    }
    return 0;
}
