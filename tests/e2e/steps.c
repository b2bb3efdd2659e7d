/* steps.c - a program whose work is in a function that makes no call, between two readings of a clock; and at
 * the end of each step, before a loop leads back to the clock. */
#include <nx.h>
#include <stdio.h>

enum { CELLS = 1000, SWEEPS = 200 };
static double cells[CELLS];

static double __attribute__((noinline)) read_clock(void)
{
    double now = dclock();
    return now + 1e-9 * cells[0];
}

static void __attribute__((noinline)) work(int sweeps)
{
    for (int k = 0; k < sweeps; k++)
        for (int i = 1; i < CELLS; i++)
            cells[i] = cells[i] * 0.5 + cells[i - 1];
}

static void __attribute__((noinline)) tidy(void)
{
    work(SWEEPS / 4);
}

int main(void)
{
    double spent = 0;
    for (int step = 0; step < 5; step++) {
        double begin = read_clock();
        work(SWEEPS);
        spent += read_clock() - begin;
        gsync();
        tidy();
    }
    if (mynode() == 0)
        printf("%g\n", spent);
    return 0;
}
