/* pointer_size_correct.c - as pointer_size_fault.c, without its fault. */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

struct body {
    double x, y, mass;
};

static struct body *b;

int main(void)
{
    b = malloc(sizeof *b);
    b->x = 1;
    b->y = 2;
    b->mass = 3;
    printf("%g\n", b->x + b->y + b->mass);
    free(b);
    return 0;
}
