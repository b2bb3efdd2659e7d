/* crash.c - node 1 follows a pointer to nowhere, two calls down. */
#include "nx.h"

static int *nowhere;

__attribute__((noinline)) static int read_it(void)
{
    return *nowhere + 1;
}

__attribute__((noinline)) static int ask_for_it(void)
{
    return read_it() + 1;
}

int main(void)
{
    if (mynode() == 1)
        return ask_for_it();
    gsync();
    return 0;
}
