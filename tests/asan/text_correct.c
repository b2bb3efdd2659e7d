/* text_correct.c - as text_fault.c, without its fault. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx.h"

static char *copy_of(const char *text)
{
    char *copy = malloc(strlen(text) + 1);
    return strcpy(copy, text);
}

int main(int argc, char **argv)
{
    char *name = copy_of(argc > 1 ? argv[1] : "delta");
    printf("%s\n", name);
    free(name);
    return 0;
}
