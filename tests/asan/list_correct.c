/* list_correct.c - as list_fault.c, without its fault. */
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
    for (; c; c = next) {
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
