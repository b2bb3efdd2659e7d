/* list.c - a list is freed, and each cell is asked for the next when it is free; another block has been
 * allocated since.
 * report: heap-use-after-free: read of 8 bytes, 8 bytes into a block of 16 bytes */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

struct cell {
    long value;
    struct cell *next;
};

static struct cell *put(long value, struct cell *next)
{
    struct cell *c = malloc(sizeof *c);
    c->value = value, c->next = next;
    return c;
}

static void free_all(struct cell *c)
{
    struct cell *next;
#ifdef CORRECT
    for (; c; c = next) {
#else
    for (; c; c = c->next) { /* FAULT */
#endif
        next = c->next;
        free(c);
        free(put(7, NULL));
    }
}

int main(void)
{
    free_all(put(1, put(2, put(3, NULL))));
    printf("done\n");
    return 0;
}
