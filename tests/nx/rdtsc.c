/* The instruction that reads a processor's counter of clocks reads the node's clock, as hwclock() does: in C
 * and assembly, by GCC's functions and by one of the program's own.
 * simulator only: on a cluster it reads the computer's
 * again: -O0
 * again: --long32
 * run: -m ipsc860 -n 2
 * run: -m paragon -n 2
 * run: -m cluster2026 -n 2
 */
#include <stdio.h>
#include <x86intrin.h>
#include "nx.h"

static unsigned long long by_assembly(void)
{
    unsigned low, high;
    __asm__ volatile("lfence\n\trdtsc" : "=a"(low), "=d"(high));
    return (unsigned long long)high << 32 | low;
}

static unsigned long long with_processor(unsigned *processor)
{
    unsigned low, high;
    __asm__ volatile("rdtscp" : "=a"(low), "=d"(high), "=c"(*processor));
    return (unsigned long long)high << 32 | low;
}

static unsigned long long ticks(void)
{
    esize_t t;
    hwclock(&t);
    return (unsigned long long)t.shigh << 32 | (unsigned)t.slow;
}

int main(void)
{
    unsigned a = 7, b = 7;
    unsigned long long read[8], n = 0, kept = 123456789;
    if (mynode() == 0)
        csend(1, NULL, 0, 1, 0);
    else
        crecv(1, NULL, 0);
    read[n++] = ticks();
    read[n++] = by_assembly();
    read[n++] = ticks();
    read[n++] = with_processor(&a);
    read[n++] = __rdtsc();
    read[n++] = __rdtscp(&b);
    for (volatile int i = 0; i < 100000; i++)
        ;
    read[n++] = by_assembly();
    read[n++] = ticks();
    int rising = 1;
    for (unsigned i = 1; i < n; i++)
        rising &= read[i] >= read[i - 1];
    if (mynode() == 1)
        printf("%d, %d, processors %u and %u, %llu\n", rising, read[7] > read[0] && read[6] > read[5], a, b,
               kept);
    return 0;
}
