/* global_underscore.c - the global operations with an underscore before their names: they check their
 * arguments, and call the plain ones. */
#include "global.h"
#include "nx.h"

static int check(long n, const void *x, const void *work)
{
    if (n < 0)
        return EQLEN;
    return n > 0 && (!x || !work) ? EQPBUF : 0;
}

#define REDUCTION(name, operation, element, expression)                                                      \
    long _##name(element x[], long n, element work[])                                                        \
    {                                                                                                        \
        int error = check((int)n, x, work);                                                                  \
        if (!error)                                                                                          \
            name(x, n, work);                                                                                \
        return nx_result(error);                                                                             \
    }
#include "reductions.def"

long _gopf(void *x, long len, void *work, long (*f)(void *a, void *b))
{
    int error = !f ? EQHND : check((int)len, x, work);
    if (!error)
        gopf(x, len, work, f);
    return nx_result(error);
}

long _gsync(void)
{
    gsync();
    return 0;
}
