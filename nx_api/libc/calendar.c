/* calendar.c - the calendar of the C library, whose answers lie in memory of the program's own. The time
 * zone is UTC. */
#include <stdio.h>
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
