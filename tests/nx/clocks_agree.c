/* dclock (seconds), mclock (milliseconds) and hwclock (ticks) never go back and tell the same time, to a
 * millisecond.
 * run: all
 */
#include <time.h>
#include "rule.h"

int main(void)
{
    double before = dclock(), now = before, after;
    unsigned long ms;
    esize_t first, then;
    int forward = 1;
    hwclock(&first);
    for (int i = 0; i < 1000; i++) {
        double next = dclock();
        forward = forward && next >= now;
        now = next;
    }
    rule("forward only", forward);
    while (dclock() < before + 0.01)
        ;
    now = dclock();
    ms = mclock();
    after = dclock(); /* on a cluster the host may take the processor away for long in between */
    rule("mclock is dclock in milliseconds", ms + 1 >= (unsigned long)(now * 1000) && ms <= after * 1000);
    hwclock(&then);
    double ticks = (double)(unsigned)then.slow - (double)(unsigned)first.slow +
                   4294967296.0 * (double)(then.shigh - first.shigh);
    rule("hwclock's ticks are of 10 or 50 MHz", ticks > 0.009 * 10e6);
    return 0;
}
