/* cut.c - nodes compute long segments without calls, all of different lengths, while one of them does what
 * its argument says: kills the others one by one, kills all, crashes, or fails. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx.h"

static double burn(long rounds)
{
    double x = 1;
    for (long i = 0; i < rounds; i++)
        x = sqrt(x + (double)i);
    return x;
}

int main(int argc, char **argv)
{
    const char *what = argc > 1 ? argv[1] : "kill";
    long me = mynode(), sum = 0, token = me;
    volatile double kept = 0;
    for (int turn = 0; turn < 5; turn++) {
        kept += burn(10000 + 3000 * ((me * 7 + turn * 3) % 11));
        csend(1, &token, sizeof token, (me + 1) % numnodes(), 0);
        crecv(1, &sum, sizeof sum);
        void *block = malloc((size_t)(1000 + 500 * turn));
        kept += block != NULL;
        free(block);
        printf("node %ld: turn %d, heard %ld at %.6f\n", me, turn, sum, dclock());
    }
    if (me != 3) {
        for (;;)
            kept += burn(me == 5 ? 1000000 : 300);
    }
    kept += burn(12345);
    if (!strcmp(what, "crash"))
        *(volatile int *)(me - 3) = 1;
    if (!strcmp(what, "fail"))
        csend(1, NULL, 8, 0, 0);
    if (!strcmp(what, "cube"))
        killcube(-1, 0);
    for (long i = 0; i < numnodes(); i++)
        if (i != me) {
            kept += burn(1000);
            killproc(i, 0);
        }
    printf("node %ld is alone at %.6f\n", me, dclock());
    return 0;
}
