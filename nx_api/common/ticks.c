/* ticks.c - what nxcc puts in the place of the instruction rdtsc (nxcc/language/tsc.cc): the ticks of
 * the node's clock. */
#include "nx.h"

unsigned long long nxc_read_tsc(void);
__attribute__((visibility("hidden"))) unsigned long long nxc_tsc;

unsigned long long nxc_read_tsc(void)
{
    esize_t ticks;
    hwclock(&ticks);
    return nxc_tsc = (unsigned long long)ticks.shigh << 32 | (unsigned)ticks.slow;
}
