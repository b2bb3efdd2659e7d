/* hsend_buffer.c - main fills the buffer of an hsend again before the handler has run that says that the
 * buffer is free.
 * With CORRECT: main does so when the handler has said, by a volatile flag, that the buffer is free.
 * variable: block */
#include <stdio.h>
#include "nx.h"

enum { BLOCK = 5, N = 1000 };
static double block[N];
static volatile int is_free;

static void sent(long type, long count, long node, long pid)
{
    is_free = 1;
}

int main(void)
{
    double first;
    int i, k;

    if (mynode() == 0) {
        for (k = 1; k <= 2; k++) {
            for (i = 0; i < N; i++)
                block[i] = k * i; /* RACE */
            is_free = 0;
            hsend(BLOCK, block, sizeof block, 1, 0, sent); /* RACE */
#ifdef CORRECT
            while (!is_free)
                flick();
        }
#else
        }
        while (!is_free)
            flick();
#endif
    } else {
        crecv(BLOCK, block, sizeof block);
        first = block[N - 1];
        crecv(BLOCK, block, sizeof block);
        printf("%.0f %.0f\n", first, block[N - 1]);
    }
    return 0;
}
