/* levels.c - a program whose work is in functions that make no call: one before the first call, and one that
 * is reached through others, between a call in a loop and the same call in the next round. */
#include <nx.h>
#include <stdio.h>

enum { CELLS = 1000, SWEEPS = 40 };
static double cells[CELLS];

static void __attribute__((noinline)) fill(int sweeps)
{
    for (int k = 0; k < sweeps; k++)
        for (int i = 0; i < CELLS; i++)
            cells[i] = 0.5 * cells[i] + i;
}

static void __attribute__((noinline)) force(int sweeps)
{
    for (int k = 0; k < sweeps; k++)
        for (int i = 1; i < CELLS; i++)
            cells[i] = cells[i] * 0.5 + cells[i - 1];
}

static double __attribute__((noinline)) energy(void)
{
    force(SWEEPS);
    double mine = cells[CELLS / 2], work;
    gdsum(&mine, 1, &work);
    return mine;
}

static double __attribute__((noinline)) step(void)
{
    return 1 + energy();
}

static void __attribute__((noinline)) run(void)
{
    double sum = 0;
    fill(SWEEPS);
    gsync();
    for (int i = 0; i < 10; i++)
        sum += step();
    if (mynode() == 0)
        printf("%g\n", sum);
}

int main(void)
{
    run();
    return 0;
}
