/* alloca.c - a line of n values has n - 1 gaps, and a place for no more.
 * With CORRECT: arrays of variable size in a loop, the blocks of which come and go, and blocks that are
 * there until the function returns.
 * report: stack-buffer-overflow: write of 8 bytes, just behind a block of alloca (40 bytes, */
#include <alloca.h>
#include <stdio.h>
#include "nx.h"

static __attribute__((noinline)) void gaps(double *gap, const double *value, long n)
{
    long i;
#ifdef CORRECT
    for (i = 0; i < n - 1; i++)
#else
    for (i = 0; i < n; i++)
#endif
        gap[i] = value[i + 1] - value[i]; /* FAULT */
}

static __attribute__((noinline)) double largest(const double *value, long n)
{
    double *gap = alloca((n - 1) * sizeof *gap), most = 0;
    long i;
    gaps(gap, value, n);
    for (i = 0; i < n - 1; i++)
        most = gap[i] > most ? gap[i] : most;
    return most;
}

#ifdef CORRECT
static __attribute__((noinline)) void set(char *all, long n)
{
    while (n-- > 0)
        all[n] = (char)n;
}

static __attribute__((noinline)) long rows(long n)
{
    long s = 0, i;
    for (i = 1; i < n; i++) {
        char row[i], *all = row;
        set(all, i);
        s += all[i - 1];
        if (i % 7 == 0)
            continue;
        {
            char more[2 * i + 3];
            set(more, 2 * i + 3);
            s += more[i];
        }
    }
    return s;
}

static __attribute__((noinline)) long lines(long n)
{
    char fixed[20], *one = alloca(n), *other = alloca(3 * n);
    set(fixed, 20);
    set(one, n);
    set(other, 3 * n);
    return one[n - 1] + other[3 * n - 1] + fixed[19] + (n > 1 ? lines(n - 1) : 0);
}
#endif

int main(void)
{
    double value[7] = {0, 1, 3, 6, 7, 7, 9};
#ifdef CORRECT
    printf("%g\n", largest(value, 6 + numnodes()));
    printf("%ld %ld\n", rows(40 + numnodes()), lines(20 + numnodes()));
    printf("%ld\n", rows(9 + numnodes()));
#else
    printf("%g\n", largest(value, 5 + numnodes()));
#endif
    return 0;
}
