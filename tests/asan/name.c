/* name.c - sprintf writes a longer name than there is room for.
 * report: stack-buffer-overflow: write of 11 bytes, the last 1 of them just behind name (10 bytes, */
#include <stdio.h>
#include "nx.h"

static void put_name(char *name, int node)
{
    sprintf(name, "part.%05d", node); /* FAULT */
}

int main(void)
{
#ifdef CORRECT
    char name[11];
#else
    char name[10];
#endif
    put_name(name, mynode());
    printf("%s\n", name);
    return 0;
}
