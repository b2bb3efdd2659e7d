/* hang.c - a host program that fails; see host.sh. */
#include <stdlib.h>
#include "cube.h"

int main(void)
{
    long x = 0;
    getcube("c", "4", "", 0);
    load("counts", 2, 0);
    crecv(77, &x, sizeof x);
    return (int)x;
}
