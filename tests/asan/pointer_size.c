/* pointer_size.c - a block is as large as a pointer to what it should hold.
 * report: heap-buffer-overflow: write of 8 bytes, just behind a block of 8 bytes */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

struct body {
    double x, y, mass;
};

static struct body *b;

int main(void)
{
#ifdef CORRECT
    b = malloc(sizeof *b);
#else
    b = malloc(sizeof b);
#endif
    b->x = 1;
    b->y = 2; /* FAULT */
    b->mass = 3;
    printf("%g\n", b->x + b->y + b->mass);
    free(b);
    return 0;
}
