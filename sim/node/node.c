/* node.c - a node's making and ending, its memory account, and its errors. See node.h. */
#include "node/node.h"
#include <assert.h>
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/cache.h"
#include "kernel/fiber.h"
#include "node/clock.h"
#include "node/engine.h"
#include "node/heap.h"
#include "node/image.h"
#include "node/isolate.h"
#include "node/libc.h"
#include "node/mailbox.h"
#include "node/span.h"
#include "node/system.h"
#include "node/trace.h"
#include "nx_api/contract/program_image.h"

/* --- errno --- */

__attribute__((noipa)) int node_errno(void)
{
    return errno;
}

__attribute__((noipa)) void node_set_errno(int error)
{
    errno = error;
}

/* --- memory --- */

size_t node_memory_limit(const struct node *n)
{
    return n->is_host ? n->sys->cfg->host.memory_bytes
                      : n->sys->cfg->memory_bytes - n->sys->cfg->system_bytes;
}

/* Without heap and messages. */
static size_t memory_fixed(const struct node *n)
{
    return n->heap ? n->image_bytes + n->sys->cfg->stack_bytes : 0; /* none: no program */
}

size_t node_memory_used(const struct node *n)
{
    return memory_fixed(n) + n->heap_known + n->buffered;
}

void node_memory_changed(struct node *n)
{
    size_t used = node_memory_used(n);
    if (used > n->stats.memory_peak)
        n->stats.memory_peak = used;
}

struct node_memory node_memory_now(const struct node *n)
{
    return (struct node_memory){n->heap_used, n->peak_ahead};
}

void node_memory_was(struct node *n, struct node_memory m)
{
    if (m.heap == n->heap_known && m.peak <= n->stats.memory_peak)
        return;
    n->heap_known = m.heap;
    if (m.peak > n->stats.memory_peak)
        n->stats.memory_peak = m.peak;
    node_memory_changed(n);
}

void node_memory_settle(struct node *n)
{
    if (n->heap_moved)
        node_memory_was(n, node_memory_now(n));
    n->heap_moved = false;
    if (!n->hands_over)
        n->buffered_known = n->buffered;
}

static int heap_room(void *ctx, size_t bytes)
{
    const struct node *n = ctx;
    return memory_fixed(n) + bytes + n->buffered_known <= node_memory_limit(n);
}

static void heap_grown(void *ctx)
{
    struct node *n = ctx;
    n->heap_used = node_heap_used(n->heap);
    n->heap_moved = true;
    size_t used = memory_fixed(n) + n->heap_used + n->buffered_known;
    if (used > n->peak_ahead)
        n->peak_ahead = used;
}

/* --- ends --- */

void node_system_fail(struct node_system *sys, enum node_stop why, const char *fmt, ...)
{
    va_list ap;
    if (sys->failure)
        return;
    va_start(ap, fmt);
    if (vasprintf(&sys->failure, fmt, ap) < 0)
        abort();
    va_end(ap);
    sys->stop = why;
}

void node_system_end_at_limit(struct node_system *sys)
{
    sys->stop_at = (struct instant){sys->max_time, UINT32_MAX};
    node_system_fail(sys, STOP_VIRTUAL_TIME, "virtual time limit of %.6f s reached",
                     vt_seconds(sys->max_time));
}

static vtime accounted(const struct node *n)
{
    return clock_of_units(n, n->clock.units) + n->stats.idle + n->stats.system;
}

/* The rule of struct node_stats. */
static bool time_adds_up(const struct node *n)
{
    const struct node_stats *s = &n->stats;
    vtime tasks = 0, waits = 0;
    for (int i = 0; i < NODE_TASKS; i++)
        tasks += s->tasks[i];
    for (size_t i = 0; i < s->waits.count; i++)
        waits += s->waits.list[i].idle;
    return accounted(n) == s->ended_at - s->away + n->clock.stolen && tasks == s->system + s->beside &&
           waits == s->idle;
}

static void has_ended(struct node *n, enum node_end how, int code, vtime at)
{
    n->end = how;
    n->exit_code = code;
    n->state = NODE_ENDED;
    n->stats.ended_at = at;
    n->sys->running--;
    if (n->sys->cube)
        mailbox_abandon(n); /* another program may come */
    if (!n->sys->await_ends)
        return;
    for (uint32_t i = 0; i < n->sys->count; i++)
        if (n->sys->nodes[i]->awaits_end)
            node_wake(n->sys->nodes[i], at);
    if (n->sys->host && n->sys->host->awaits_end)
        node_wake(n->sys->host, at);
}

_Noreturn void node_end_here(struct node *n, enum node_end how, int code)
{
    if (!n->sys->stop)
        node_order(n);
    has_ended(n, how, code, node_now(n));
    assert(time_adds_up(n));
    fiber_finish(&n->fiber);
}

void node_stop(struct node *n, struct instant at)
{
    node_cut(n, at);
    n->stats.away = at.time - accounted(n);
}

void node_end_other(struct node *n, struct node *victim)
{
    vtime now = node_now(n);
    if (victim->state == NODE_ENDED)
        return;
    node_stop(victim, (struct instant){now, n->place});
    has_ended(victim, NODE_KILLED, 0, now);
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
    n->sys->stop_at = (struct instant){node_now(n), n->place};
    if (frame && !n->sys->failure)
        trace_print_calls(f, n, (uintptr_t)frame);
    fclose(f);
    node_system_fail(n->sys, STOP_FAILED, "%s, at %.9f s: %s", n->name, vt_seconds(node_now(n)), text);
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

void node_output(struct node *n, int fd, const char *bytes, size_t len)
{
    FILE *const *out = n->sys->out;
    if (fd == 2)
        fflush(out[0]); /* both may be one file */
    fwrite(bytes, 1, len, out[fd - 1]);
}

size_t node_long_bytes(const struct node *n)
{
    return (size_t)n->image->long_bytes;
}

long node_get_long(const struct node *n, const long *array, size_t i)
{
    return node_long_bytes(n) == sizeof(int32_t) ? ((const int32_t *)array)[i] : array[i];
}

void node_put_long(const struct node *n, long *array, size_t i, long value)
{
    if (node_long_bytes(n) == sizeof(int32_t))
        ((int32_t *)array)[i] = (int32_t)value;
    else
        array[i] = value;
}

void node_system_note_absent(struct node_system *sys, const char *function, const char *node)
{
    size_t i = 0;
    while (i < sys->absent_count && strcmp(sys->absent[i].function, function) != 0)
        i++;
    if (i == sys->absent_count) {
        sys->absent = reallocarray(sys->absent, i + 1, sizeof *sys->absent);
        if (!sys->absent)
            abort();
        sys->absent[sys->absent_count++] = (struct node_absent){strdup(function), strdup(node), 0};
    }
    sys->absent[i].calls++;
}

/* --- making --- */

static void run_program(void *arg)
{
    struct node *n = arg;
    node_leave(n);
    for (void (**f)(void) = n->image->init_begin; f < n->image->init_end; f++)
        (*f)();
    int code = n->image->main(n->argc, n->argv, n->envp);
    node_enter(n, "exit");
    node_libc_end(n);
    node_end_here(n, NODE_RETURNED, code);
}

/* Enough for the node's memory, which bounds its program, heap and stack. */
static bool fits(const struct node *n, const struct node_image *img, char **error)
{
    size_t program = node_image_bytes(img), stack = n->sys->cfg->stack_bytes;
    if (program + stack <= node_memory_limit(n))
        return true;
    if (asprintf(
            error,
            "%s does not fit: program %zu bytes and stack %zu bytes, but a node of %s leaves %zu to programs",
            node_image_path(img), program, stack, n->sys->cfg->name, node_memory_limit(n)) < 0)
        abort();
    return false;
}

static bool make_parts(struct node *n, const struct node_image *img, char **error)
{
    if (!fits(n, img, error))
        return false;
    if (!span_take(n, node_image_bytes(img), node_image_is_long32(img))) {
        if (asprintf(error, "%s: no address space left on this computer", n->name) < 0)
            abort();
        return false;
    }
    n->libc = node_libc_new(n);
    if (!node_image_map(img, n, error))
        return false;
    n->heap = node_heap_new(n->heap_start, n->region->heap_bytes, heap_room, heap_grown, n);
    fiber_begin(&n->fiber, n->stack, n->stack_bytes, run_program, n);
    isolate_made(n);
    node_memory_changed(n);
    return true;
}

static void set_clock(struct node *n)
{
    const struct cfg_machine *c = n->sys->cfg;
    bool fast = c->fast_every && n->id % c->fast_every == 0;
    clock_set(n, fast ? c->fast_clock_hz : c->clock_hz);
    n->system_milli = fast ? (uint32_t)cfg_fast_system_milli(c) : 1000;
}

static struct node *make(struct node_system *sys, uint32_t id)
{
    sys->made.bytes = (sizeof(struct node) + CACHE_BLOCK - 1) / CACHE_BLOCK * CACHE_BLOCK;
    sys->made_beside.bytes = sizeof(struct node_beside);
    struct node *n = pool_take(&sys->made);
    *n = (struct node){.beside = pool_take(&sys->made_beside)};
    memset(n->beside, 0, sizeof *n->beside);
    n->error = &n->beside->error;
    n->sys = sys, n->id = n->place = id;
    set_clock(n);
    snprintf(n->name, sizeof n->name, "node %u", id);
    mailbox_begin(n, &n->beside->ids);
    n->info = (struct node_info){-1, -1, -1, -1};
    n->pending.begun = VT_NEVER;
    return n;
}

static struct node *load(struct node *n, const struct node_image *img, int argc, char **argv, char **envp,
                         char **error)
{
    n->argc = argc, n->argv = argv, n->envp = envp;
    if (make_parts(n, img, error))
        return n;
    node_delete(n);
    return NULL;
}

struct node *node_new(struct node_system *sys, uint32_t id, const struct node_image *img, int argc,
                      char **argv, char **envp, char **error)
{
    return load(make(sys, id), img, argc, argv, envp, error);
}

struct node *node_new_empty(struct node_system *sys, uint32_t id)
{
    struct node *n = make(sys, id);
    n->state = NODE_ENDED;
    n->end = NODE_NOT_LOADED;
    return n;
}

struct node *node_new_host(struct node_system *sys, uint32_t place, const struct node_image *img, int argc,
                           char **argv, char **envp, char **error)
{
    struct node *n = make(sys, sys->count);
    n->is_host = true;
    n->place = place;
    clock_set(n, sys->cfg->host.clock_hz);
    n->system_milli = (uint32_t)sys->cfg->host.system_milli;
    snprintf(n->name, sizeof n->name, "host");
    return load(n, img, argc, argv, envp, error);
}

/* All but what messages and events may still refer to. */
static void strip(struct node *n)
{
    if (n->stripped)
        return;
    n->stripped = true;
    engine_forget(n);
    if (n->sys->proto)
        mailbox_abandon(n); /* what its messages under way would tell */
    mailbox_end(n);
    waits_free(&n->stats.waits);
    free(n->crash);
    if (n->libc)
        node_libc_free(n);
    fiber_end(&n->fiber);
    if (n->heap)
        node_heap_free(n->heap);
    if (n->sys->writable == n)
        n->sys->writable = NULL;
    span_release(n);
    n->crash = NULL, n->stats.waits = (struct node_waits){0}, n->libc = NULL, n->heap = NULL;
    n->image = NULL, n->left = n->quiet = NULL, n->clock.runs = false;
}

void node_succeed(struct node *n, struct node *before, vtime t)
{
    size_t peak = n->stats.memory_peak;
    clock_set_units(n, before->clock.units);
    n->stats = before->stats;
    n->armed = before->armed;
    before->stats.waits = (struct node_waits){0};
    n->stats.away = t - accounted(n);
    n->stats.memory_peak = peak > n->stats.memory_peak ? peak : n->stats.memory_peak;
    n->sys_free = before->sys_free;
    mailbox_inherit(n, before);
    strip(before);
}

void node_delete(struct node *n)
{
    if (!n)
        return;
    strip(n);
    pool_give(&n->sys->made_beside, n->beside);
    pool_give(&n->sys->made, n);
}
