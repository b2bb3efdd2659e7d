/* kind.c - a host program that fails; see host.sh. */
#include <stdlib.h>
#include "cube.h"

int main(void)
{
    long x = 0;
    getcube("c", "4vx", "", 0);
    return (int)x;
}
