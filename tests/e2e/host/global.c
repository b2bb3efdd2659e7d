/* global.c - a host program that fails; see host.sh. */
#include "cube.h"

int main(void)
{
    getcube("c", "4", "", 0);
    gsync();
    return 0;
}
