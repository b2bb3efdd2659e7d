/* circle.c - exercise 4: all nodes shall learn the largest number of any node.
 *
 *    nxcc -g -O2 -o circle circle.c
 *    touchstone run -q -n 8 circle
 *
 * The numbers go once around a circle: each node takes what comes from the left, and sends the larger
 * of that and its own to the right. It hangs. Why? */
#include <stdio.h>
#include <nx.h>

enum { LARGEST = 1 };

int main(void)
{
    long right = (mynode() + 1) % numnodes(), largest = (mynode() * 37 + 11) % 101, came;
    int i;

    for (i = 1; i < numnodes(); i++) {
        crecv(LARGEST, &came, sizeof came);
        if (came > largest)
            largest = came;
        csend(LARGEST, &largest, sizeof largest, right, 0);
    }
    printf("node %ld: the largest is %ld\n", mynode(), largest);
    return 0;
}
