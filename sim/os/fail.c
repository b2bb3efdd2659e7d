/* fail.c - see fail.h. */
#include "os/fail.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include "os/end.h"
#include "os/gate.h"

void node_system_fail(struct node_system *sys, enum stop why, struct instant at, const char *fmt, ...)
{
    va_list ap;
    if (sys->failure)
        return;
    va_start(ap, fmt);
    if (vasprintf(&sys->failure, fmt, ap) < 0)
        abort();
    va_end(ap);
    schedule_stop(&sys->schedule, why, at);
}

void node_system_end_at_limit(struct node_system *sys)
{
    vtime limit = sys->schedule.max_time;
    node_system_fail(sys, STOP_VIRTUAL_TIME, (struct instant){limit, UINT32_MAX},
                     "virtual time limit of %.6f s reached", vt_seconds(limit));
}

long node_error(struct node *n, int code, const char *fmt, ...)
{
    va_list ap;
    va_start(ap, fmt);
    vsnprintf(n->error->text, sizeof n->error->text, fmt, ap);
    va_end(ap);
    n->error->code = code;
    return -1;
}

/* Names the calls from frame upwards, unless it is NULL. */
static _Noreturn void fail(struct node *n, const void *frame, const char *fmt, va_list ap)
{
    char *text = NULL;
    size_t size;
    node_order(n);
    FILE *f = open_memstream(&text, &size);
    if (!f)
        abort();
    vfprintf(f, fmt, ap);
    if (frame && !n->sys->failure && n->sys->print_calls)
        n->sys->print_calls(f, n, (uintptr_t)frame);
    fclose(f);
    node_system_fail(n->sys, STOP_FAILED, (struct instant){node_now(n), n->lp.address}, "%s, at %.9f s: %s",
                     n->name, vt_seconds(node_now(n)), text);
    free(text);
    node_end_here(n, NODE_CRASHED, 1);
}

_Noreturn void node_fail_in(struct node *n, const void *frame, const char *fmt, ...)
{
    va_list ap;
    va_start(ap, fmt);
    fail(n, frame, fmt, ap);
}

_Noreturn void node_fail(struct node *n, const char *fmt, ...)
{
    va_list ap;
    va_start(ap, fmt);
    fail(n, __builtin_frame_address(0), fmt, ap);
}
