/* lost_update.c - a stack whose height is volatile: main reads it, takes the top, and writes it back in
 * another statement. A handler may put a number onto the stack in between, and its height is forgotten.
 * The word that is only cleared, news, loses nothing.
 * With CORRECT: the same, and main masks the handler from the reading to the writing.
 * variable: height */
#include <stdio.h>
#include "nx.h"

enum { NUMBER = 5, DONE = 6, EACH = 5 };
static long stack[100], came, taken;
static volatile long height, arrived, news;

static void on_number(long type, long count, long node, long pid)
{
    stack[height++] = came; /* RACE */
    arrived++;
    news = 1;
    hrecv(NUMBER, &came, sizeof came, on_number);
}

static long pop(void)
{
    long top, number = 0;

#ifdef CORRECT
    masktrap(1);
#endif
    top = height;
    if (top > 0) {
        number = stack[top - 1];
        height = top - 1; /* RACE */
        taken++;
    }
#ifdef CORRECT
    masktrap(0);
#endif
    return number;
}

int main(void)
{
    long sum = 0, i;

    if (mynode() == 0) {
        hrecv(NUMBER, &came, sizeof came, on_number);
        csend(DONE, NULL, 0, 1, 0);
        while (arrived < EACH || height > 0) {
            if (news)
                news = 0; /* before it looks: a handler that comes now is seen */
            sum += pop();
        }
        printf("sum %ld\n", sum);
    } else {
        crecv(DONE, NULL, 0);
        for (i = 1; i <= EACH; i++)
            csend(NUMBER, &i, sizeof i, 0, 0);
    }
    return 0;
}
