/* alloca_correct.c - as alloca_fault.c, without its fault; and arrays of variable size in a loop, the blocks
 * of which come and go, and blocks that are there until the function returns. */
#include <alloca.h>
#include <stdio.h>
#include "nx.h"

static __attribute__((noinline)) void gaps(double *gap, const double *value, long n)
{
    long i;
    for (i = 0; i < n - 1; i++)
        gap[i] = value[i + 1] - value[i];
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

int main(void)
{
    double value[7] = {0, 1, 3, 6, 7, 7, 9};
    printf("%g\n", largest(value, 6 + numnodes()));
    printf("%ld %ld\n", rows(40 + numnodes()), lines(20 + numnodes()));
    printf("%ld\n", rows(9 + numnodes()));
    return 0;
}
