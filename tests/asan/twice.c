/* twice.c - two owners free one block.
 * report: double-free: free was given a block of 24 bytes that is free already */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

struct part {
    double *mass;
};

static struct part here, there;

int main(void)
{
    here.mass = malloc(24);
    there = here;
    there.mass[1] = 2;
    printf("%g\n", here.mass[1]);
    free(here.mass);
#ifdef CORRECT
    there.mass = NULL;
#endif
    free(there.mass); /* FAULT */
    return 0;
}
