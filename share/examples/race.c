/* race.c - a stack that a handler fills and the main program empties, and nothing keeps the two apart.
 *
 *    nxcc -g -O2 -o race race.c
 *    touchstone run -n 2 race      the sum is right
 *    touchstone run -n 4 race      it is too small
 *
 * Node 0 collects numbers. A handler puts each onto a stack; the main program takes the top one, works on
 * it, and writes the new height back. A number that comes meanwhile lies above the old top: the height
 * that is written back forgets it. From one node numbers come so slowly that none does, in the usual
 * timing; from several nodes they come at any time.
 *
 * The remedy: take the number and lower the height at once, between masktrap(1) and masktrap(0). */
#include <stdio.h>
#include <nx.h>

enum { NUMBER = 1, EACH = 20, ROOM = 4096 };

static long stack[ROOM], came; /* the handler's message */
static volatile long height, arrived;

static void on_number(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    stack[height++] = came;
    arrived++;
    hrecv(NUMBER, &came, sizeof came, on_number);
}

static double field[2000];

static void work(int points)
{
    int i;

    for (i = 1; i < points; i++)
        field[i] = 0.5 * (field[i - 1] + field[i] + 1);
}

static long collect(long numbers)
{
    long sum = 0;

    hrecv(NUMBER, &came, sizeof came, on_number);
    while (arrived < numbers || height > 0) {
        long top = height - 1;

        if (top < 0) {
            flick(); /* gives the processor away until something has come */
            continue;
        }
        sum += stack[top];
        work(500);
        height = top; /* numbers that have come during work() are forgotten */
    }
    return sum;
}

int main(void)
{
    long others = numnodes() - 1, i;

    if (mynode() == 0) {
        long sum = collect(EACH * others), right = others * EACH * (EACH + 1) / 2;

        printf("sum %ld, which should be %ld\n", sum, right);
    }
    for (i = 1; mynode() > 0 && i <= EACH; i++) {
        work(2000);
        csend(NUMBER, &i, sizeof i, 0, 0);
    }
    return 0;
}
