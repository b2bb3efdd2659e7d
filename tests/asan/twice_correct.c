/* twice_correct.c - as twice_fault.c, without its fault. */
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
    there.mass = NULL;
    free(there.mass);
    return 0;
}
