/* leaves.c - a host program that fails; see host.sh. */
#include <stdlib.h>
#include "cube.h"

int main(void)
{
    long x = 0;
    getcube("c", "d2", "", 0);
    load("counts", -1, 0);
    return (int)x;
}
