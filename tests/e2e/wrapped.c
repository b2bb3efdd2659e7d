/* wrapped.c - a program whose calls of NX are in functions of their own. One works behind its call; with an
 * argument, another function works, between two calls of together(). */
#include <nx.h>

enum { CELLS = 1000, SWEEPS = 40, STEPS = 5 };
static double cells[CELLS], news[CELLS];

static void __attribute__((noinline)) together(void)
{
    gsync();
}

static void __attribute__((noinline)) unpack(void)
{
    crecv(1, news, sizeof news);
    for (int k = 0; k < SWEEPS; k++)
        for (int i = 1; i < CELLS; i++)
            cells[i] = 0.5 * cells[i] + news[i] - cells[i - 1];
}

static void __attribute__((noinline)) grind(void)
{
    for (int k = 0; k < SWEEPS; k++)
        for (int i = 1; i < CELLS; i++)
            cells[i] = 0.5 * cells[i] + cells[i - 1];
}

int main(int argc, char **argv)
{
    (void)argv;
    for (int step = 0; argc > 1 && step < STEPS; step++) {
        grind();
        together();
    }
    for (int step = 0; argc == 1 && step < STEPS; step++) {
        csend(1, cells, sizeof cells, (mynode() + 1) % numnodes(), 0);
        unpack();
        together();
    }
    return 0;
}
