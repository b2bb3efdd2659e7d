/* endless.c - node: computes for ever. */
#include "cube.h"

int main(void)
{
    volatile double x = 1;
    for (;;)
        x = x * 0.999 + 1;
}
