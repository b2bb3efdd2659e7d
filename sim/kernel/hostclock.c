/* hostclock.c - see hostclock.h. */
#include <time.h>
#include "kernel/hostclock.h"

double hostclock_s(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
