/* destructors.c - at a program's end, returned from main or by exit, its functions of atexit run, the
 * last first, then its destructors, the last first; what they print is there.
 * run: all
 */
#include <stdio.h>
#include <stdlib.h>
#include "nx.h"

static void say(const char *what)
{
    if (mynode() == 0)
        printf("%s\n", what);
}

__attribute__((destructor(201))) static void first_made(void)
{
    say("destructor 201");
}

__attribute__((destructor(202))) static void second_made(void)
{
    say("destructor 202");
}

static void registered_first(void)
{
    say("atexit 1");
}

static void registered_last(void)
{
    say("atexit 2");
}

int main(void)
{
    atexit(registered_first);
    atexit(registered_last);
    gsync();
    if (numnodes() > 1)
        exit(0);
    return 0;
}
