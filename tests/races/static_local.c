/* static_local.c - main and the handler call a function that keeps its state in a static variable: a
 * number may be given out twice. Both accesses are the function's.
 * With CORRECT: the function masks handlers while its state changes.
 * variable: last */
#include <stdio.h>
#include "nx.h"

enum { WANT = 5, NUMBER = 6, END = 7, WANTS = 4 };

static long new_number(void)
{
    static long last;
#ifdef CORRECT
    long before = masktrap(1), number = ++last;

    masktrap(before);
    return number;
#else

    return ++last; /* RACE */
#endif
}

static void on_want(long type, long count, long node, long pid)
{
    long number = new_number();

    csend(NUMBER, &number, sizeof number, node, 0);
    hrecv(WANT, NULL, 0, on_want);
}

int main(void)
{
    long sum = 0, other;
    int i;

    if (mynode() == 0) {
        hrecv(WANT, NULL, 0, on_want);
        for (i = 0; i < WANTS; i++)
            sum += new_number();
        crecv(END, &other, sizeof other);
        printf("sum of numbers %ld\n", sum + other);
    } else {
        for (i = 0; i < WANTS; i++) {
            csendrecv(WANT, NULL, 0, 0, 0, NUMBER, &other, sizeof other);
            sum += other;
        }
        csend(END, &sum, sizeof sum, 0, 0);
    }
    return 0;
}
