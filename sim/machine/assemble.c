/* assemble.c - see assemble.h. */
#include "machine/assemble.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include "kernel/crossing.h"
#include "kernel/xalloc.h"
#include "guest/debugger.h"
#include "guest/heap.h"
#include "guest/image.h"
#include "guest/libc/libc.h"
#include "guest/libc/own_memory.h"
#include "guest/span.h"
#include "lp/engine.h"
#include "machine/crash.h"
#include "notes/livelock.h"
#include "notes/taken.h"
#include "os/charge.h"
#include "os/end.h"
#include "os/gate.h"
#include "os/isolate.h"
#include "os/match.h"
#include "os/memory.h"
#include "os/observer.h"
#include "record/node_record.h"
#include "profile/path_times.h"
#include "mpi_api/checks/mpi_checks.h"
#include "races/race_check.h"
#include "replay/numbering.h"
#include "asan/asan_check.h"
#include "lp/clock.h"
#include "node/self.h"
#include "trace/recorder.h"

static void run_program(void *arg)
{
    struct node *n = arg;
    node_leave(n);
    for (void (**f)(void) = n->guest.image->fini_begin; f < n->guest.image->fini_end; f++)
        node_libc_at_end(n, *f);
    for (void (**f)(void) = n->guest.image->init_begin; f < n->guest.image->init_end; f++)
        crossing_call(*f, 0, 0, 0, 0, 0);
    int code = (int)crossing_call(n->guest.image->main, n->cold->argc, (long)n->cold->argv,
                                  (long)node_libc_envp(n), 0, 0);
    node_enter(n, "exit");
    node_libc_end(n);
    node_end_here(n, n->sys->main_tells ? NODE_EXITED : NODE_RETURNED, code);
}

/* Does the node's memory, which bounds its program, heap and stack together, hold program and stack? */
static bool fits(const struct node *n, const struct node_image *img, char **error)
{
    size_t program = node_image_bytes(img), stack = n->sys->cfg->stack_bytes;
    if (program + stack <= node_memory_limit(n))
        return true;
    *error = xasprintf(
        "%s does not fit: program %zu bytes and stack %zu bytes, but a node of %s leaves %zu to programs; "
        "--set node.memory_mb=N gives more",
        node_image_path(img), program, stack, n->sys->cfg->name, node_memory_limit(n));
    return false;
}

/* (A thread that waits may still touch its stack, which --isolate does not allow.) */
static void show_debugger(struct node *n)
{
    debugger_add(n->sys->debugger, n);
    if (!n->sys->isolate)
        fiber_take_thread(&n->lp.fiber, n->cold->name, crash_thread_begins, crash_thread_ends);
}

/* Nodes take address space a region at a time, whatever they use of it. */
static bool lacks_addresses(const struct node *n, char **error)
{
    struct rlimit allowed;
    if (getrlimit(RLIMIT_AS, &allowed) != 0 || allowed.rlim_cur == RLIM_INFINITY)
        *error = xasprintf(
            "%s: no address space left on this computer: nodes take it by %zu MB or more, in two mappings; "
            "raise vm.max_map_count (sysctl), or give nodes less memory (memory_mb), so that more share "
            "%zu MB",
            n->cold->name, (size_t)NODE_REGION >> 20, (size_t)NODE_REGION >> 20);
    else
        *error = xasprintf(
            "%s: no address space left: nodes take it by %zu MB or more, most of which they never touch, and "
            "ulimit -v allows %zu MB in all; ulimit -v unlimited lifts that limit",
            n->cold->name, (size_t)NODE_REGION >> 20, (size_t)allowed.rlim_cur >> 20);
    return false;
}

static int heap_has_room(void *ctx, size_t bytes)
{
    span_guard_heap(ctx);
    return memory_has_room(ctx, bytes);
}

static bool make_parts(struct node *n, const struct node_image *img, int argc, char **argv, char **error)
{
    if (!fits(n, img, error))
        return false;
    if (!span_take(n, img, node_image_bytes(img), own_arguments_bytes(argc, argv), node_image_is_long32(img),
                   node_image_is_asan(img)))
        return lacks_addresses(n, error);
    own_put_arguments(n, argc, argv);
    if (!node_image_map(img, n, node_libc_data, error))
        return false;
    *n->guest.image->data_cache = (int64_t)n->sys->cfg->cache_bytes;
    if (node_image_is_asan(img) && !(n->asan = asan_begin(n->sys->asan, n)))
        return lacks_addresses(n, error);
    n->guest.heap =
        node_heap_new(n->asan ? asan_heap_base(n->asan) : n->guest.heap_start,
                      n->guest.region->heap_bytes - own_memory_bytes(n), heap_has_room, memory_heap_is, n);
    fiber_begin(&n->lp.fiber, n->guest.system_stack, NODE_SYSTEM_STACK, run_program, n);
    struct crossing_top *top = (void *)(n->guest.stack + n->guest.stack_bytes);
    top->has_errno = node_image_has_errno(img);
    crossing_begin(&n->lp.fiber, top);
    if (n->sys->debugger)
        show_debugger(n);
    isolate_made(n);
    node_memory_changed(n);
    return true;
}

/* The processor has so many clocks a second, or fewer in a run with another timing than usual. */
static void set_hz(struct node *n, uint64_t hz)
{
    const struct timing *t = n->sys->timing;
    clock_set(&n->lp, t ? timing_clock_hz(t, node_timed(n), hz) : hz);
}

static void set_clock(struct node *n)
{
    const struct cfg_machine *c = n->sys->cfg;
    bool fast = c->fast_every && n->id % c->fast_every == 0;
    set_hz(n, fast ? c->fast_clock_hz : c->clock_hz);
    n->system_milli = fast ? (uint32_t)cfg_fast_system_milli(c) : 1000;
}

static struct node *make(struct node_system *sys, uint32_t id, uint32_t address)
{
    sys->made.bytes = (sizeof(struct node) + CACHE_BLOCK - 1) / CACHE_BLOCK * CACHE_BLOCK;
    sys->made_cold.bytes = sizeof(struct node_cold);
    struct node *n = arena_take(&sys->made);
    *n = (struct node){.cold = arena_take(&sys->made_cold)};
    memset(n->cold, 0, sizeof *n->cold);
    n->sys = sys, n->id = id;
    n->is_host = topo_is_host(&sys->topo, address);
    lp_begin(&n->lp, &sys->schedule, address);
    set_clock(n);
    snprintf(n->cold->name, sizeof n->cold->name, "node %u", id);
    match_begin(n);
    if (sys->numbering)
        numbering_begin(n);
    n->info = (struct node_info){-1, -1, -1, -1};
    n->deferred.begun = VT_NEVER;
    return n;
}

void node_record(struct node *n)
{
    record_begin(n, recorder_program(n->sys->recorder, node_image_path(n->guest.file)));
}

static struct node *load(struct node *n, const struct node_image *img, int argc, char **argv, char **envp,
                         char **error)
{
    n->cold->envp = envp;
    if (make_parts(n, img, argc, argv, error)) {
        n->deferred.never |= n->sys->cfg->entry_ps != 0; /* for charge_entry */
        /* (Where programs come and go, few messages are worth deferring calls.) */
        n->deferred.never |= n->is_host || n->asan || n->sys->cube || n->sys->flushes;
        taken_begin(n);
        livelock_begin(n);
        path_times_begin(n);
        races_begin(n->sys->races, n);
        mpi_checks_begin(n->sys->mpi_checks, n);
        if (n->sys->recorder)
            node_record(n);
        return n;
    }
    node_delete(n);
    return NULL;
}

struct node *node_new(struct node_system *sys, uint32_t id, const struct node_image *img, int argc,
                      char **argv, char **envp, char **error)
{
    return load(make(sys, id, id), img, argc, argv, envp, error);
}

struct node *node_new_empty(struct node_system *sys, uint32_t id)
{
    struct node *n = make(sys, id, id);
    lp_end(&n->lp);
    n->end.how = NODE_NOT_LOADED;
    return n;
}

struct node *node_new_host(struct node_system *sys, uint32_t address, const struct node_image *img, int argc,
                           char **argv, char **envp, char **error)
{
    assert(!sys->host);
    struct node *n = make(sys, sys->count, address);
    set_hz(n, sys->cfg->host.clock_hz);
    n->system_milli = (uint32_t)sys->cfg->host.system_milli;
    snprintf(n->cold->name, sizeof n->cold->name, "host");
    return load(n, img, argc, argv, envp, error);
}

void node_start(struct node *n, vtime t)
{
    vtime late = n->sys->timing ? timing_start(n->sys->timing, node_timed(n)) : 0;
    n->stats.away += late;
    if (late)
        ANNOUNCE(n, no_program, t + late);
    lp_start(&n->lp, t + late);
}

/* Frees all of a node except what messages and events may still refer to. */
static void strip(struct node *n)
{
    if (n->stripped)
        return;
    n->stripped = true;
    lp_forget(&n->lp);
    if (n->sys->schedule.protocol)
        match_abandon(n); /* what its messages under way would report to */
    match_end(n);
    if (n->sys->numbering)
        numbering_end(n);
    waits_free(&n->stats.waits);
    taken_end(n);
    path_times_end(n);
    livelock_end(n);
    races_end(n);
    mpi_checks_end(n->sys->mpi_checks, n);
    if (n->asan)
        asan_end(n), n->asan = NULL;
    free(n->cold->crash);
    if (n->guest.libc)
        node_libc_free(n);
    fiber_end(&n->lp.fiber);
    if (n->sys->debugger)
        debugger_remove(n->sys->debugger, n);
    if (n->guest.heap)
        node_heap_free(n->guest.heap);
    if (n->sys->writable == n)
        n->sys->writable = NULL;
    span_release(n);
    n->cold->crash = NULL, n->stats.waits = (struct node_waits){0}, n->guest.libc = NULL,
    n->guest.heap = NULL;
    n->guest.image = NULL;
    lp_unbind(&n->lp);
}

void node_succeed(struct node *n, struct node *before, vtime t)
{
    assert(before != n && before->lp.state == LP_ENDED);
    size_t peak = n->stats.memory_peak;
    clock_set_units(&n->lp, before->lp.clock.units);
    n->times = before->times;
    n->stats = before->stats;
    n->handlers.armed = before->handlers.armed;
    before->stats.waits = (struct node_waits){0};
    n->stats.away = t - charge_sum(n);
    n->stats.memory_peak = peak > n->stats.memory_peak ? peak : n->stats.memory_peak;
    n->times.sys_free = before->times.sys_free;
    match_inherit(n, before);
    races_succeed(n, before);
    strip(before);
}

void node_delete(struct node *n)
{
    if (!n)
        return;
    strip(n);
    free(n->cold->deferred);
    free(n->cold->error);
    arena_give(&n->sys->made_cold, n->cold);
    arena_give(&n->sys->made, n);
}
