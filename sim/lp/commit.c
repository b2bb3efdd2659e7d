/* commit.c - the fast engine's loop: events are committed in order, by the calling thread; see turns.h. */
#include <stddef.h>
#include "kernel/workers.h"
#include "node/system.h"
#include "lp/dispatch.h"

const char ENGINE_NAME[] = "fast";

static struct node *node_of(struct work *w)
{
    return (struct node *)((char *)w - offsetof(struct node, ahead.work));
}

/* The earliest event, if nothing that is out may come before it; else something is done about that. False: there is none,
 * and nothing out. */
static bool commit_event(struct node_system *s)
{
    bool out = s->workers && workers_busy(s->workers);
    if (!out && s->max_time == VT_NEVER)
        return node_step(s);
    for (struct work *w; out && (w = workers_take(s->workers));)
        node_catch(node_of(w));
    uint32_t place;
    vtime next = node_next(s, &place);
    if (out && !workers_allow(s->workers, next, place)) {
        s->unseen += 64; /* it may have taken long */
        workers_advance(s->workers, next, place);
        return true;
    }
    if (next == VT_NEVER)
        return out && workers_busy(s->workers);
    if (next > s->max_time)
        node_system_end_at_limit(s);
    return next <= s->max_time && node_step(s);
}

/* Flattened: after a switch to a program and back no processor foresees where a function returns to. */
__attribute__((flatten)) static void commit_events(struct node_system *s)
{
    enum { LOOK_EVERY = 1024 };
    for (uint64_t i = 0; !s->stop && commit_event(s); i++)
        if (i % LOOK_EVERY == 0 || s->unseen > LOOK_EVERY)
            s->look(s->look_ctx);
}

/* The machine has been stopped: programs that were let off come as far as the others. */
static void catch_up(struct node_system *s)
{
    for (uint32_t i = 0; s->stop && i < s->count; i++)
        node_catch_up(s->nodes[i], s->stop_at.time);
    if (s->stop && s->host)
        node_catch_up(s->host, s->stop_at.time);
}

static void *thread_begins(void *ctx)
{
    const struct engine_threads *t = ctx;
    return t->begin();
}

static bool thread_runs(void *own, struct work *w)
{
    (void)own;
    return node_run_ahead(node_of(w));
}

struct workers_stats engine_run(struct node_system *s, const struct engine_threads *threads)
{
    const struct workers_calls calls = {(void *)threads, thread_begins, thread_runs, threads->end};
    struct workers_stats stats = {0};
    if (threads->count > 1)
        s->workers = workers_new(threads->count - 1, threads->shuffle, &calls, threads->own);
    commit_events(s);
    if (s->workers)
        workers_halt(s->workers);
    catch_up(s);
    if (s->workers) {
        stats = workers_stats(s->workers);
        workers_free(s->workers);
        s->workers = NULL;
    }
    return stats;
}
