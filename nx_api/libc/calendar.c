/* calendar.c - the calendar of the C library, whose answers lie in memory of the program's own. The time
 * zone is UTC. */
#define _GNU_SOURCE
#include <stdio.h>
#include <sys/time.h>
#include <sys/timeb.h>
#include <time.h>

char *tzname[2] = {"UTC", "UTC"};
__typeof__(timezone) timezone; /* not this program's long under --long32 */
int daylight;

static struct tm broken_down;

void tzset(void) {}

static struct tm *break_down(const time_t *t, struct tm *into)
{
    long long wide = *t; /* long32: the library's time_t has 64 bits */
    return gmtime_r((const time_t *)&wide, into);
}

struct tm *gmtime(const time_t *t)
{
    return break_down(t, &broken_down);
}

struct tm *localtime(const time_t *t)
{
    return gmtime(t);
}

/* There is no summer time: what says so is an hour late. */
time_t mktime(struct tm *tm)
{
    if (tm->tm_isdst > 0)
        tm->tm_hour--;
    return timegm(tm);
}

time_t timelocal(struct tm *tm)
{
    return mktime(tm);
}

int ftime(struct timeb *t)
{
    struct timeval now;
    gettimeofday(&now, NULL);
    *t = (struct timeb){.time = (time_t)now.tv_sec, .millitm = (unsigned short)(now.tv_usec / 1000)};
    return 0;
}

/* The node's clocks have nanoseconds. */
int clock_getres(clockid_t clock, struct timespec *least)
{
    (void)clock;
    if (least)
        *least = (struct timespec){.tv_nsec = 1};
    return 0;
}

char *asctime(const struct tm *tm)
{
    static char text[64];
    return asctime_r(tm, text);
}

char *ctime(const time_t *t)
{
    return asctime(gmtime(t));
}

char *ctime_r(const time_t *t, char *text)
{
    struct tm own;
    return asctime_r(break_down(t, &own), text);
}
