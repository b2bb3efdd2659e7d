/* dclock (seconds), mclock (milliseconds) and hwclock (ticks) never go back and tell the same time, to a
 * millisecond; so do getclock and gettimeofday.
 * run: all
 */
#include <errno.h>
#include <sys/time.h>
#include <sys/timers.h>
#include "rule.h"

static double seconds(void)
{
    struct timeval t;
    gettimeofday(&t, NULL);
    return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
}

/* OSF/1's clock. */
static int getclock_agrees(void)
{
    struct timespec t;
    double before = seconds();
    int good = getclock(TIMEOFDAY, &t) == 0;
    double now = (double)t.tv_sec + 1e-9 * (double)t.tv_nsec, after = seconds();
    return good && now >= before - 1e-6 && now <= after + 1e-6 && getclock(TIMEOFDAY + 1, &t) == -1 &&
           errno == EINVAL;
}

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
    rule("getclock agrees with gettimeofday", getclock_agrees());
    return 0;
}
