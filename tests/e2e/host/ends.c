/* ends.c - node: ends, the higher nodes earlier. */
#include <stdlib.h>
#include "cube.h"

int main(void)
{
    double until = dclock() + 0.01 * (4 - mynode());
    while (dclock() < until)
        ;
    exit((int)mynode());
}
