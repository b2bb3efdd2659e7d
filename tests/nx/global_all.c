/* All global operations, on any number of nodes: results as computed here from all nodes' elements.
 * run: -m ipsc860 -n 1
 * run: -m ipsc860 -n 2
 * run: -m ipsc860 -n 3
 * run: -m ipsc860 -n 8
 * run: -m delta -n 33
 */
#include <nx.h>
#include <stdio.h>
#include <string.h>

enum { N = 5 };
static long wrong;

/* Element i of node k: positive and negative, small enough for a product of 33. */
static long element(long k, long i)
{
    return i == 0 ? 1 + k % 2 : i == 1 ? -1 : (k * 7 + i * 3) % 5 - 2;
}

#define CHECK(name, type, expression)                                                                        \
    do {                                                                                                     \
        type x[N], work[N];                                                                                  \
        long i, k;                                                                                           \
        for (i = 0; i < N; i++)                                                                              \
            x[i] = (type)element(mynode(), i);                                                               \
        name(x, N, work);                                                                                    \
        for (i = 0; i < N; i++) {                                                                            \
            type a = (type)element(0, i), b;                                                                 \
            for (k = 1; k < numnodes(); k++)                                                                 \
                b = (type)element(k, i), a = (type)(expression);                                             \
            wrong += (numnodes() > 1 || #name[1] != 'l') && x[i] != a;                                       \
        }                                                                                                    \
    } while (0)

static void reductions(void)
{
    CHECK(gdsum, double, a + b);
    CHECK(gdprod, double, a *b);
    CHECK(gdhigh, double, a > b ? a : b);
    CHECK(gdlow, double, a < b ? a : b);
    CHECK(gssum, float, a + b);
    CHECK(gsprod, float, a *b);
    CHECK(gshigh, float, a > b ? a : b);
    CHECK(gslow, float, a < b ? a : b);
    CHECK(gisum, long, a + b);
    CHECK(giprod, long, a *b);
    CHECK(gihigh, long, a > b ? a : b);
    CHECK(gilow, long, a < b ? a : b);
    CHECK(giand, long, a &b);
    CHECK(gior, long, a | b);
    CHECK(gixor, long, a ^ b);
    CHECK(gland, long, a &&b);
    CHECK(glor, long, a || b);
    CHECK(glxor, long, !a != !b);
    CHECK(_gssum, float, a + b);
    CHECK(_glor, long, a || b);
}

/* Not commutative: the product of 2 x 2 matrices, in the order of the nodes. */
static long multiply(void *a, void *b)
{
    double *x = a, *y = b,
           r[4] = {x[0] * y[0] + x[1] * y[2], x[0] * y[1] + x[1] * y[3], x[2] * y[0] + x[3] * y[2],
                   x[2] * y[1] + x[3] * y[3]};
    memcpy(a, r, sizeof r);
    return 0;
}

static void any_operation(void)
{
    long k, n = numnodes();
    double mine[4] = {1, (double)mynode(), 0, 1}, all[4] = {1, 0, 0, 1}, work[4];
    for (k = 0; k < n; k++)
        multiply(all, (double[]){1, (double)k, 0, 1});
    gopf(mine, sizeof mine, work, multiply);
    wrong += memcmp(mine, all, sizeof all) != 0;
}

/* Types of the library and of the program do not mix: a receive of any type does not take the library's
 * messages. */
static void types(void)
{
    static char buf[8];
    long id = irecv(-1, buf, sizeof buf);
    gsync();
    reductions();
    csend(0, "program", 8, mynode(), 0);
    msgwait(id);
    wrong += strcmp(buf, "program") != 0;
}

int main(void)
{
    long work;
    reductions();
    any_operation();
    types();
    wrong += _gsync() != 0;
    gisum(&wrong, 1, &work);
    if (mynode() == 0)
        printf("%ld wrong\n", wrong);
    return 0;
}
