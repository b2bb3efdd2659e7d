/* gamma.c - the logarithm of the gamma function, which leaves its sign in a variable of the program's own. */
#include <math.h>

int signgam;

#define LGAMMA(type, name, old, with_sign)                                                                   \
    type name(type x)                                                                                        \
    {                                                                                                        \
        return with_sign(x, &signgam);                                                                       \
    }                                                                                                        \
    type old(type x)                                                                                         \
    {                                                                                                        \
        return with_sign(x, &signgam);                                                                       \
    }
LGAMMA(double, lgamma, gamma, lgamma_r)
LGAMMA(float, lgammaf, gammaf, lgammaf_r)
LGAMMA(long double, lgammal, gammal, lgammal_r)
