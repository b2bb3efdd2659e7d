/* votes_solved.c - a solution of exercise 4 (b): no handler runs while votes are added.
 *
 *    nxcc --races -g -O2 -o votes_solved votes_solved.c
 *    touchstone run -q -n 4 votes_solved
 */
#include <stdio.h>
#include <nx.h>

enum { VOTES = 1, EACH = 100 };

static long votes, packet; /* the handler's message */
static volatile long packets;

static void on_votes(long type, long count, long node, long pid)
{
    (void)type, (void)count, (void)node, (void)pid;
    votes += packet;
    packets++;
    hrecv(VOTES, &packet, sizeof packet, on_votes);
}

static double field[2000];

/* What a node does to find a vote. */
static long find(int points)
{
    int i;

    for (i = 1; i < points; i++)
        field[i] = 0.5 * (field[i - 1] + field[i] + 1);
    return field[points - 1] > 0;
}

int main(void)
{
    long i, own = EACH;

    if (mynode() > 0) {
        for (i = 0; i < EACH; i++)
            find(500);
        csend(VOTES, &own, sizeof own, 0, 0);
        return 0;
    }
    hrecv(VOTES, &packet, sizeof packet, on_votes);
    for (i = 0; i < EACH; i++) {
        long found = find(500);

        masktrap(1);
        votes += found;
        masktrap(0);
    }
    while (packets < numnodes() - 1)
        flick(); /* gives the processor away until something has come */
    printf("%ld votes\n", votes);
    return 0;
}
