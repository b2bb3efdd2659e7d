/* fail.c - the way out when something is wrong; see fail.h. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <nx.h>
#include "fail.h"

void fail(const char *format, ...)
{
    va_list arguments;
    char text[512];
    long i;

    masktrap(1);
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    fprintf(stderr, "model: node %ld: %s\n", mynode(), text); /* in one call: other nodes print, too */
    fflush(stderr);
    for (i = 0; i < numnodes(); i++)
        if (i != mynode())
            killproc(i, 0);
    exit(1);
}

void *allocate_if_room(size_t bytes)
{
    long old = masktrap(1);
    void *p = malloc(bytes);

    masktrap(old);
    return p;
}

void *allocate(size_t bytes)
{
    void *p = allocate_if_room(bytes);

    if (!p)
        fail("out of memory (%lu bytes asked for)", (unsigned long)bytes);
    return p;
}
