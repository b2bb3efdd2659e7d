/* circle_solved.c - a solution of exercise 4 (a): each node sends before it receives.
 *
 *    nxcc -g -O2 -o circle_solved circle_solved.c
 *    touchstone run -q -n 8 circle_solved
 *
 * csend returns when the message has left; NX keeps it until the receiver asks. */
#include <stdio.h>
#include <nx.h>

enum { LARGEST = 1 };

int main(void)
{
    long right = (mynode() + 1) % numnodes(), largest = (mynode() * 37 + 11) % 101, came;
    int i;

    for (i = 1; i < numnodes(); i++) {
        csend(LARGEST, &largest, sizeof largest, right, 0);
        crecv(LARGEST, &came, sizeof came);
        if (came > largest)
            largest = came;
    }
    printf("node %ld: the largest is %ld\n", mynode(), largest);
    return 0;
}
