/* first_failure.c - see first_failure.h. */
#include "os/first_failure.h"
#include <stdarg.h>
#include "files/virtual_time.h"
#include "kernel/xalloc.h"

void node_system_fail(struct node_system *sys, enum stop why, struct instant at, const char *fmt, ...)
{
    va_list ap;
    if (sys->failure)
        return;
    va_start(ap, fmt);
    sys->failure = xvasprintf(fmt, ap);
    va_end(ap);
    schedule_stop(&sys->schedule, why, at);
}

void node_system_end_at_limit(struct node_system *sys)
{
    if (sys->pauses && sys->pauses(sys))
        return;
    vtime limit = sys->schedule.max_time;
    node_system_fail(sys, STOP_VIRTUAL_TIME, (struct instant){limit, UINT32_MAX},
                     limit == VT_LAST ? "virtual time ends at %s" : "virtual time limit of %s reached",
                     virtual_time_moment(limit).text);
}
