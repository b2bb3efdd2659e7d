/* A handler never runs inside the C library: the program is in malloc, free and snprintf nearly all the time, and so are
 * its handlers, which look whether it is. */
#include <nx.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MESSAGES = 3000, BLOCKS = 64 };
static volatile int inside;
static volatile long handled, caught;
static char box[8];

static void handler(long type, long count, long node, long pid)
{
    char text[80], *p = malloc((size_t)(handled % 5000));
    (void)count, (void)pid;
    caught += inside;
    snprintf(text, sizeof text, "%ld of %f", handled, (double)handled / 3);
    free(p);
    handled++;
    hrecv(type, box, sizeof box, handler);
    if (handled % 100 == 0)
        csend(2, 0, 0, node, 0);
}

int main(void)
{
    char *block[BLOCKS] = {0}, text[400];
    unsigned long i, k;
    if (mynode() == 1) {
        for (i = 0; i < MESSAGES; i++) {
            csend(1, box, sizeof box, 0, 0);
            if (i % 100 == 99)
                crecv(2, 0, 0);
        }
        return 0;
    }
    hrecv(1, box, sizeof box, handler);
    for (i = 0; handled < MESSAGES; i++) {
        k = i * 7 % BLOCKS;
        inside = 1;
        free(block[k]);
        block[k] = malloc(i * 131 % 40000);
        snprintf(text, sizeof text, "%300lu %f", i, (double)i);
        inside = 0;
        if (block[k])
            memset(block[k], (int)i, i * 131 % 40000);
    }
    printf("%ld handled, %ld inside\n", handled, caught);
    return 0;
}
