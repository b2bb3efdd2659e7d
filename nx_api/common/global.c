/* global.c - global operations on vectors, made of calls of nx.h: the same on every back end.
 *
 * Each node has a vector; at the end all nodes have the vectors combined, element by element. This is
 * recursive doubling: let p be the largest power of two that is no more than the number of nodes. In step k
 * each of the nodes 0 to p-1 exchanges its vector with the node whose number differs in bit k, and combines
 * the two. A node from p on first sends its vector to node - p, which combines the two, and at the end gets
 * the result from there. With 6 nodes:
 *
 *     node      0     1     2     3     4     5
 *     fold      <-----------------------'     |        4 to 0, 5 to 1
 *                     <-----------------------'
 *     bit 0     <----->     <----->
 *     bit 1     <----------->
 *                     <----------->
 *     tell      ------------------------>              0 to 4, 1 to 5
 *                     ------------------------->
 *
 * Both partners combine the lower node's vector with the higher node's, in this order. So all nodes associate
 * alike, and their results are equal bit for bit.
 *
 * Message types are reserved ones, which programs do not use: one for each operation and step. A node gets
 * messages of one such type from one other node only, and messages of one type between two nodes keep their
 * order. So no message of the next call or operation is taken for one of the present.
 */
#include <stdint.h>
#include <string.h>
#include "global.h"
#include "nx.h"

enum { FOLD = 62, TELL = 63 };

struct global {
    long type; /* of the operation's step 0 */
    nx_combine *combine;
    long n, bytes;
    void *x, *work;
};

/* Sends x to a partner, gets the partner's x into work, combines both. The receive is posted first, so that
 * the partner's message finds its buffer. */
static void exchange(const struct global *g, long step, long me, long partner)
{
    long id = irecv(g->type + step, g->work, g->bytes);
    csend(g->type + step, g->x, g->bytes, partner, 0);
    msgwait(id);
    if (me < partner)
        g->combine(g->x, g->x, g->work, g->n);
    else
        g->combine(g->x, g->work, g->x, g->n);
}

static void run(const struct global *g)
{
    long me = mynode(), nodes = numnodes(), p = 1;
    while (p <= nodes / 2)
        p *= 2;
    if (me >= p) {
        csend(g->type + FOLD, g->x, g->bytes, me - p, 0);
        crecv(g->type + TELL, g->x, g->bytes);
        return;
    }
    if (me + p < nodes) {
        crecv(g->type + FOLD, g->work, g->bytes);
        g->combine(g->x, g->x, g->work, g->n);
    }
    for (long bit = 1, step = 0; bit < p; bit *= 2, step++)
        exchange(g, step, me, me ^ bit);
    if (me + p < nodes)
        csend(g->type + TELL, g->x, g->bytes, me + p, 0);
}

/* Of n, as of all arguments, the low 32 bits count. */
void nx_reduce(enum nx_operation op, nx_combine *f, long n, size_t size, void *x, void *work)
{
    n = (int)n;
    const struct global g = {GLOBAL_FIRST_TYPE + op * GLOBAL_TYPES, f, n, n * (long)size, x, work};
    run(&g);
}

#define REDUCTION(name, operation, element, expression)                                                      \
    static void name##_combine(void *out, const void *low, const void *high, long n)                         \
    {                                                                                                        \
        for (long i = 0; i < n; i++) {                                                                       \
            element a = ((const element *)low)[i], b = ((const element *)high)[i];                           \
            ((element *)out)[i] = (expression);                                                              \
        }                                                                                                    \
    }                                                                                                        \
    void name(element x[], long n, element work[])                                                           \
    {                                                                                                        \
        nx_reduce(operation, name##_combine, n, sizeof(element), x, work);                                   \
    }

#include "reductions.def"

/* The program's operation during gopf. f(low, high) leaves the result in low. */
static long (*program_operation)(void *, void *);

static void gopf_combine(void *out, const void *low, const void *high, long bytes)
{
    program_operation((void *)(uintptr_t)low, (void *)(uintptr_t)high);
    if (out != low)
        memcpy(out, low, (size_t)bytes);
}

void gopf(void *x, long len, void *work, long (*f)(void *, void *))
{
    program_operation = f;
    nx_reduce(GOPF, gopf_combine, len, 1, x, work);
}
