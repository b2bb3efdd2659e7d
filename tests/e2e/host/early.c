/* early.c - a host program that fails; see host.sh. */
#include <stdlib.h>
#include "cube.h"

int main(void)
{
    long x = 0;
    getcube("c", "4m16", "", 0);
    csend(1, &x, sizeof x, 2, 0);
    return (int)x;
}
