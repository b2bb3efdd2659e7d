/* bench.h - shared by the microbenchmarks: the clock, and the form of their results.
 *
 * A program prints lines "figure NAME VALUE" and "point SERIES X... Y" from one node; `make validate` reads
 * these lines and compares the figures with published ones (published.cfg). Any other line is a remark.
 */
#ifndef BENCH_H
#define BENCH_H
#include <nx.h>
#include <stdio.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

static inline double now_us(void)
{
    return 1e6 * dclock();
}

static inline void figure(const char *name, double value)
{
    printf("figure %s %.9g\n", name, value);
}
#endif
