/* gray.c - the binary reflected Gray code: neighbours in its sequence are neighbours in the hypercube. */
#include "nx.h"

long gray(long n)
{
    int code = (int)n; /* only these bits count */
    return code ^ (code >> 1);
}

long ginv(long n)
{
    unsigned g = (unsigned)n;
    for (unsigned shift = 1; shift < 8 * sizeof g; shift *= 2)
        g ^= g >> shift;
    return (int)g;
}

long _gray(long n)
{
    return gray(n);
}

long _ginv(long n)
{
    return ginv(n);
}
