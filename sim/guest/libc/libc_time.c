/* libc_time.c - the C library's clocks, which show the node's virtual time.
 *
 * When a program starts, the calendar always shows the same date: results must not depend on the day on
 * which they are made. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/times.h>
#include <time.h>
#include <unistd.h>
#include "kernel/xalloc.h"
#include "lp/engine.h"
#include "guest/libc/libc_parts.h"
#include "node/node.h"
#include "node/system.h"
#include "lp/clock.h"
#include "guest/libc/host_errno.h"
#include "node/self.h"
#include "os/fail.h"
#include "os/front.h"
#include "os/gate.h"

#define EPOCH ((time_t)725846400)                    /* 1993-01-01 00:00:00 UTC */
#define LAST_MOMENT (VT_NEVER - 1000000 * VT_SECOND) /* to wait for: the program may go on for some days */

/* The time at which a clock call returns to the program, and the node's idle and system time so far. */
struct reading {
    vtime now, idle, system;
};

static struct reading read_clock(const char *call)
{
    struct node *n = node_self();
    node_enter(n, call);
    node_spend(n, n->sys->cfg->clock_call_ps + n->sys->cfg->unix_call_ps);
    struct reading r = {node_now(n), n->stats.idle, n->times.system};
    node_leave(n);
    return r;
}

static vtime clock_call(const char *call)
{
    return read_clock(call).now;
}

time_t node_time(time_t *t)
{
    time_t now = EPOCH + (time_t)(clock_call("time") / VT_SECOND);
    if (t != NULL)
        *t = now;
    return now;
}

/* Processor time is the node's time less its idle time. */
clock_t node_clock(void)
{
    struct reading r = read_clock("clock");
    return (clock_t)((r.now - r.idle) / (VT_SECOND / CLOCKS_PER_SEC));
}

int node_gettimeofday(struct timeval *tv, void *zone)
{
    vtime now = clock_call("gettimeofday");
    if (zone != NULL)
        *(struct timezone *)zone = (struct timezone){0};
    if (tv != NULL)
        *tv = (struct timeval){EPOCH + (time_t)(now / VT_SECOND),
                               (suseconds_t)(now % VT_SECOND / VT_MICROSECOND)};
    return 0;
}

/* All clocks show one time: CLOCK_REALTIME from EPOCH on, the others from the program's start. */
int node_clock_gettime(clockid_t clock, struct timespec *ts)
{
    struct reading r = read_clock("clock_gettime");
    bool own = clock == CLOCK_PROCESS_CPUTIME_ID || clock == CLOCK_THREAD_CPUTIME_ID;
    if (clock < CLOCK_REALTIME || clock > CLOCK_TAI) {
        node_set_errno(EINVAL);
        return -1;
    }
    vtime now = own ? r.now - r.idle : r.now;
    ts->tv_sec = (time_t)(now / VT_SECOND) + (clock == CLOCK_REALTIME ? EPOCH : 0);
    ts->tv_nsec = (long)(now % VT_SECOND / (VT_SECOND / 1000000000));
    return 0;
}

/* Reports user and system time only; the other figures are 0, as are all of a program's children: it has
 * none. */
int node_getrusage(int who, struct rusage *use)
{
    struct reading r = read_clock("getrusage");
    if (who == RUSAGE_CHILDREN) {
        r = (struct reading){0};
    } else if (who != RUSAGE_SELF && who != RUSAGE_THREAD) {
        node_set_errno(EINVAL);
        return -1;
    }
    vtime user = r.now - r.idle - r.system;
    *use = (struct rusage){
        .ru_utime = {(time_t)(user / VT_SECOND), (suseconds_t)(user % VT_SECOND / VT_MICROSECOND)},
        .ru_stime = {(time_t)(r.system / VT_SECOND), (suseconds_t)(r.system % VT_SECOND / VT_MICROSECOND)}};
    return 0;
}

/* Counts in ticks of sysconf(_SC_CLK_TCK), from the program's start. A program has no children. */
clock_t node_times(struct tms *t)
{
    struct reading r = read_clock("times");
    vtime tick = VT_SECOND / (vtime)sysconf(_SC_CLK_TCK);
    if (t != NULL)
        *t = (struct tms){.tms_utime = (clock_t)((r.now - r.idle - r.system) / tick),
                          .tms_stime = (clock_t)(r.system / tick)};
    return (clock_t)(r.now / tick);
}

/* --- timers: they run, but their signals never come, as a program gets none but those that end it --- */

/* The microseconds that are left of a timer when its clock shows `now`. 0: it does not run. */
static uint64_t timer_left(const struct node_timer *t, vtime now)
{
    uint64_t passed = (now - t->from) / VT_MICROSECOND;
    if (passed < t->first)
        return t->first - passed;
    return t->every > 0 ? t->every - (passed - t->first) % t->every : 0;
}

static uint64_t micro(const struct timeval *t)
{
    return (uint64_t)t->tv_sec * 1000000 + (uint64_t)t->tv_usec;
}

static struct timeval timeval_of(uint64_t t)
{
    return (struct timeval){(time_t)(t / 1000000), (suseconds_t)(t % 1000000)};
}

/* The answer is what was left of the alarm before. */
unsigned node_alarm(unsigned seconds)
{
    struct node_timer *t = &libc_of(node_self())->timers[ITIMER_REAL];
    vtime now = clock_call("alarm");
    uint64_t left = timer_left(t, now);
    *t = (struct node_timer){now, (uint64_t)seconds * 1000000, 0};
    return (unsigned)((left + 999999) / 1000000);
}

/* What the clock of a timer shows: the node's, that of its user time, or of user and system time. */
static vtime timer_clock(const struct reading *r, int which)
{
    return r->now - (which == ITIMER_REAL ? 0 : r->idle) - (which == ITIMER_VIRTUAL ? r->system : 0);
}

static bool is_time(const struct timeval *t)
{
    return t->tv_sec >= 0 && t->tv_sec <= INT32_MAX && t->tv_usec >= 0 && t->tv_usec < 1000000;
}

static int wrong_timer(void)
{
    errno = EINVAL;
    return -1;
}

/* `to` and `before` may be NULL. */
static int use_timer(const char *call, int which, const struct itimerval *to, struct itimerval *before)
{
    if (which < ITIMER_REAL || which > ITIMER_PROF)
        return wrong_timer();
    struct node_timer *t = &libc_of(node_self())->timers[which];
    struct reading r = read_clock(call);
    vtime now = timer_clock(&r, which);
    struct itimerval was = {timeval_of(t->every), timeval_of(timer_left(t, now))};
    uint64_t first = to ? micro(&to->it_value) : 0;
    if (to)
        *t = (struct node_timer){now, first, first > 0 ? micro(&to->it_interval) : 0};
    if (before)
        *before = was;
    return 0;
}

int node_getitimer(int which, struct itimerval *to)
{
    return use_timer("getitimer", which, NULL, to);
}

int node_setitimer(int which, const struct itimerval *to, struct itimerval *before)
{
    if (to && !(is_time(&to->it_value) && is_time(&to->it_interval)))
        return wrong_timer();
    return use_timer("setitimer", which, to ? to : &(struct itimerval){0}, before);
}

useconds_t node_ualarm(useconds_t first, useconds_t every)
{
    struct itimerval to = {timeval_of(every), timeval_of(first)}, before;
    use_timer("ualarm", ITIMER_REAL, &to, &before);
    return (useconds_t)micro(&before.it_value);
}

/* The format with GNU's %s, also with flags, as in %-s, replaced by the seconds: the host's strftime would
 * compute them for the host's time zone. For free(). */
static char *without_seconds(const char *format, const struct tm *tm)
{
    struct tm copy = *tm;
    char seconds[24], *made = xmalloc(strlen(format) * sizeof seconds + 1), *to = made;
    snprintf(seconds, sizeof seconds, "%lld", (long long)timegm(&copy));
    while (*format) {
        size_t flags = *format == '%' ? strspn(format + 1, "_-0^#+123456789EO") : 0;
        char conversion = *format == '%' ? format[1 + flags] : 0;
        size_t bytes = conversion ? flags + 2 : 1;
        to = conversion == 's' ? stpcpy(to, seconds) : (char *)memcpy(to, format, bytes) + bytes;
        format += bytes;
    }
    *to = 0;
    return made;
}

size_t node_strftime(char *buf, size_t room, const char *format, const struct tm *tm)
{
    char *plain = without_seconds(format, tm);
    struct tm here = *tm;
    if (!here.tm_zone)
        here.tm_zone = "UTC"; /* else it is the host's */
    size_t len = strftime(buf, room, plain, &here);
    free(plain);
    return len;
}

/* But GNU's %s, which would make a time of the host's zone: there it ends. */
char *node_strptime(const char *text, const char *format, struct tm *tm)
{
    for (const char *at = format; (at = strchr(at, '%')) != NULL && at[1] != 0; at += 2)
        if (at[1] == 's')
            return NULL;
    return strptime(text, format, tm);
}

/* The zone's name is the node's own, too. */
struct tm *node_gmtime_r(const time_t *t, struct tm *tm)
{
    struct tm *answer = gmtime_r(t, tm);
    if (answer)
        tm->tm_zone = own_memory_text(node_self(), tm->tm_zone);
    return answer;
}

/* The machine's time zone is UTC. */
struct tm *node_localtime_r(const time_t *t, struct tm *tm)
{
    return node_gmtime_r(t, tm);
}

static bool is_over(struct node *n, void *until)
{
    return node_now(n) >= *(vtime *)until;
}

/* Waits for so many seconds and picoseconds, or as long as virtual time has moments. Meanwhile messages are
 * received and handlers run. */
static void pause_for(const char *call, uint64_t seconds, vtime t)
{
    struct node *n = node_self();
    node_enter(n, call);
    vtime now = node_now(n), left = now < LAST_MOMENT ? LAST_MOMENT - now : 0;
    if (left == 0)
        node_fail(n, "%s: virtual time ends here", call);
    t = seconds < left / VT_SECOND ? vt_min(left, seconds * VT_SECOND + t) : left;
    vtime until = now + t;
    if (t > 0) {
        lp_wake(&n->lp, until);
        node_wait(n, is_over, &until);
    }
    node_leave(n);
}

/* When the timer ends next: now, if it does not run. */
static vtime timer_due(const struct node_timer *t, vtime now)
{
    uint64_t most = (UINT64_MAX - now) / VT_MICROSECOND - 1, left = timer_left(t, now);
    vtime rest = (now - t->from) % VT_MICROSECOND;
    return left > 0 ? now + (left < most ? left : most) * VT_MICROSECOND - rest : now;
}

/* Returns when the alarm is due, as if its signal had come; with no alarm set, at once. */
int node_pause(void)
{
    struct node_timer *t = &libc_of(node_self())->timers[ITIMER_REAL];
    vtime now = clock_call("pause"), due = timer_due(t, now);
    pause_for("pause", 0, due - now);
    *t = (struct node_timer){due, t->every, t->every};
    node_set_errno(EINTR);
    return -1;
}

int node_sigpause(int number)
{
    (void)number;
    return node_pause();
}

/* By the name that X/Open's sigpause has in the host's header. */
int node___xpg_sigpause(int number)
{
    return node_sigpause(number);
}

int node_sigsuspend(const void *mask)
{
    (void)mask;
    return node_pause();
}

unsigned node_sleep(unsigned seconds)
{
    pause_for("sleep", seconds, 0);
    return 0;
}

int node_usleep(unsigned microseconds)
{
    pause_for("usleep", 0, microseconds * VT_MICROSECOND);
    return 0;
}

int node_nanosleep(const struct timespec *t, struct timespec *left)
{
    if (t->tv_sec < 0 || t->tv_nsec < 0 || t->tv_nsec >= 1000000000) {
        errno = EINVAL;
        return -1;
    }
    pause_for("nanosleep", (uint64_t)t->tv_sec, (vtime)t->tv_nsec * (VT_SECOND / 1000000000));
    if (left != NULL)
        *left = (struct timespec){0};
    return 0;
}
