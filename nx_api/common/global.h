/* global.h - what calls that are node code themselves share: reserved message types (nx.h), and errors. */
#ifndef COMMON_GLOBAL_H
#define COMMON_GLOBAL_H
#include <errno.h>
#include <stddef.h>

/* Each operation has GLOBAL_TYPES types: those of global.c in its order, the others from here on. */
enum { GLOBAL_FIRST_TYPE = 1000000000, GLOBAL_TYPES = 64, GLOBAL_GCOL = 100, GLOBAL_GCOL_LENGTHS };

/* out = low combined with high, n elements; out is one of the two. */
typedef void nx_combine(void *out, const void *low, const void *high, long n);

#define REDUCTION(name, operation, element, expression) operation,
enum nx_operation {
    GSYNC, /* gsync.c */
#include "reductions.def"
    GOPF,
};
#undef REDUCTION

/* Combines all nodes' x, n elements of size bytes; work is as long. */
void nx_reduce(enum nx_operation op, nx_combine *f, long n, size_t size, void *x, void *work);

/* Ends the process as a plain call does: the message names call and node, and says what the errno value
 * stands for. The back end serves it. */
_Noreturn void nx_fail(const char *call, int error);

/* What a call with an underscore returns: 0, or -1 and errno. */
static inline long nx_result(int error)
{
    if (!error)
        return 0;
    errno = error;
    return -1;
}

#endif
