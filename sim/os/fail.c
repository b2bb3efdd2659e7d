/* fail.c - see fail.h. */
#include "os/fail.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include "files/virtual_time.h"
#include "kernel/xalloc.h"
#include "nx_api/contract/backend.h"
#include "os/end.h"
#include "os/first_failure.h"
#include "os/order.h"

/* Names the calls from frame upwards, unless it is NULL. */
static _Noreturn void fail(struct node *n, const void *frame, const char *fmt, va_list ap)
{
    char *text = NULL;
    size_t size;
    node_order(n);
    FILE *f = xchecked(open_memstream(&text, &size));
    vfprintf(f, fmt, ap);
    if (frame && !n->sys->failure && n->sys->print_calls)
        n->sys->print_calls(f, n, (uintptr_t)frame);
    fclose(f);
    node_system_fail(n->sys, STOP_FAILED, (struct instant){node_now(n), n->lp.address}, "%s, at %s: %s",
                     n->cold->name, virtual_time_moment(node_now(n)).text, text);
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
