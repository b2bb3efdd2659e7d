/* f77_reductions.c - global operations from Fortran. Those on INTEGER and LOGICAL have elements of 4 bytes,
 * where C has longs; they use the message types of the C names. */
#include <stdlib.h>
#include "f77_entry.h"

typedef integer long_element;
typedef double double_element;
typedef float float_element;

#define REDUCTION(name, operation, element, expression)                                                      \
    static void name##_combine(void *out, const void *low, const void *high, long n)                         \
    {                                                                                                        \
        for (long i = 0; i < n; i++) {                                                                       \
            element##_element a = ((const element##_element *)low)[i];                                       \
            element##_element b = ((const element##_element *)high)[i];                                      \
            ((element##_element *)out)[i] = (element##_element)(expression);                                 \
        }                                                                                                    \
    }                                                                                                        \
    ENTRY void name##_(element##_element x[], in *n, element##_element work[])                               \
    {                                                                                                        \
        nx_reduce(operation, name##_combine, *n, sizeof *x, x, work);                                        \
    }
#include "../common/reductions.def"

ENTRY void gsync_(void)
{
    gsync();
}

/* f: EXTERNAL, f(a, b) leaves the result in a. */
ENTRY void gopf_(void *x, in *bytes, void *work, long (*f)(void *, void *))
{
    gopf(x, *bytes, work, f);
}

ENTRY void gcol_(const void *x, in *len, void *y, in *room, integer *total)
{
    long n;
    gcol(x, *len, y, *room, &n);
    *total = (integer)n;
}

ENTRY void gcolx_(const void *x, in lens[], void *y)
{
    long *longs = nx_fortran_longs(lens, numnodes(), "gcolx");
    gcolx(x, longs, y);
    free(longs);
}
