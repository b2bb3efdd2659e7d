/* gray.c - the binary reflected Gray code: neighbours in its sequence are neighbours in the hypercube. */
#include "nx.h"

long gray(long n)
{
    return n ^ (n >> 1);
}

long ginv(long n)
{
    unsigned long g = (unsigned long)n;
    for (unsigned shift = 1; shift < 8 * sizeof g; shift *= 2)
        g ^= g >> shift;
    return (long)g;
}

long _gray(long n)
{
    return gray(n);
}

long _ginv(long n)
{
    return ginv(n);
}
