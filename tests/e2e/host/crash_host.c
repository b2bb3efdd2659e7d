/* crash_host.c - a host program that fails; see host.sh. */
#include <stdlib.h>
#include "cube.h"

int main(void)
{
    long x = 0;
    x = *(volatile long *)16;
    return (int)x;
}
