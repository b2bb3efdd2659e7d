/* name_correct.c - as name_fault.c, without its fault. */
#include <stdio.h>
#include "nx.h"

static void put_name(char *name, int node)
{
    sprintf(name, "part.%05d", node);
}

int main(void)
{
    char name[11];
    put_name(name, mynode());
    printf("%s\n", name);
    return 0;
}
