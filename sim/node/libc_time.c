/* libc_time.c - the C library's clocks, which are the node's virtual time.
 *
 * The calendar starts at a fixed moment when the program starts: results must not depend on the day they were
 * made.
 */
#include <sys/resource.h>
#include <sys/time.h>
#include <time.h>
#include "node/engine.h"
#include "node/node.h"
#include "node/system.h"

#define EPOCH ((time_t)725846400) /* 1993-01-01 00:00:00 UTC */

/* The time when a clock call returns to the program, and what it is made of. */
struct reading {
    vtime now, idle, system;
};

static struct reading read_clock(const char *call)
{
    struct node *n = node_self();
    node_enter(n, call);
    node_spend(n, n->sys->cfg->clock_call_ps);
    struct reading r = {node_now(n), n->stats.idle, n->stats.system};
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

/* Processor time: what the node did not spend waiting. */
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
    tv->tv_sec = EPOCH + (time_t)(now / VT_SECOND);
    tv->tv_usec = (suseconds_t)(now % VT_SECOND / VT_MICROSECOND);
    return 0;
}

/* All clocks are one: the calendar's, and those that count from the program's start. */
int node_clock_gettime(clockid_t clock, struct timespec *ts)
{
    struct reading r = read_clock("clock_gettime");
    bool own = clock == CLOCK_PROCESS_CPUTIME_ID || clock == CLOCK_THREAD_CPUTIME_ID;
    vtime now = own ? r.now - r.idle : r.now;
    ts->tv_sec = (time_t)(now / VT_SECOND) + (clock == CLOCK_REALTIME ? EPOCH : 0);
    ts->tv_nsec = (long)(now % VT_SECOND / (VT_SECOND / 1000000000));
    return 0;
}

/* Only the two times; the others are 0. */
int node_getrusage(int who, struct rusage *use)
{
    struct reading r = read_clock("getrusage");
    vtime user = r.now - r.idle - r.system;
    (void)who;
    *use = (struct rusage){
        .ru_utime = {(time_t)(user / VT_SECOND), (suseconds_t)(user % VT_SECOND / VT_MICROSECOND)},
        .ru_stime = {(time_t)(r.system / VT_SECOND), (suseconds_t)(r.system % VT_SECOND / VT_MICROSECOND)}};
    return 0;
}

/* The machine's time zone is UTC. */
struct tm *node_localtime_r(const time_t *t, struct tm *tm)
{
    return gmtime_r(t, tm);
}

static bool is_over(struct node *n, void *until)
{
    return node_now(n) >= *(vtime *)until;
}

/* Messages are handled and handlers run meanwhile. */
static void pause_for(const char *call, vtime t)
{
    struct node *n = node_self();
    node_enter(n, call);
    vtime until = node_now(n) + t;
    if (t > 0) {
        node_wake(n, until);
        node_wait(n, is_over, &until);
    }
    node_leave(n);
}

unsigned node_sleep(unsigned seconds)
{
    pause_for("sleep", seconds * VT_SECOND);
    return 0;
}

int node_usleep(unsigned microseconds)
{
    pause_for("usleep", microseconds * VT_MICROSECOND);
    return 0;
}
