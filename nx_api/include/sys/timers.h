/* timers.h - OSF/1's clock of the day, for programs of the Paragon. (Source: getclock(3) of OSF/1.) */
#ifndef NX_SYS_TIMERS_H
#define NX_SYS_TIMERS_H
#include <errno.h>
#include <time.h>

#define TIMEOFDAY 1

/* Reads the time since 1970. Returns 0; -1 with errno EINVAL, if the clock is not TIMEOFDAY. */
static inline int getclock(int clock, struct timespec *now)
{
    if (clock == TIMEOFDAY)
        return clock_gettime(CLOCK_REALTIME, now);
    errno = EINVAL;
    return -1;
}
#endif
