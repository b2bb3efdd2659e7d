/* text.c - a copy of a text has no room for the 0 at its end.
 * report: heap-buffer-overflow: write of 6 bytes, the last 1 of them just behind a block of 5 bytes */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx.h"

static char *copy_of(const char *text)
{
#ifdef CORRECT
    char *copy = malloc(strlen(text) + 1);
#else
    char *copy = malloc(strlen(text));
#endif
    return strcpy(copy, text); /* FAULT */
}

int main(int argc, char **argv)
{
    char *name = copy_of(argc > 1 ? argv[1] : "delta");
    printf("%s\n", name);
    free(name);
    return 0;
}
