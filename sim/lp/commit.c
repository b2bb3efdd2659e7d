/* commit.c - the fast engine's loop: the coordinator commits events in the total order, one at a time. */
#include "lp/commit.h"
#include "lp/dispatch.h"
#include "lp/engine.h"
#include "lp/offload.h"
#include "lp/upcalls.h"
#include "lp/wake.h"

const char ENGINE_NAME[] = "fast";

/* The coordinator looks at host time and signals after so many events, or calls of programs. */
enum { LOOK_EVERY = 1024 };

/* The earliest event, of the queue or a node's poll time: its time, VT_NEVER if there is none, and address.
 */
static vtime next_event(const struct schedule *s, uint32_t *address)
{
    vtime time = evq_next(s->q);
    *address = evq_next_address(s->q);
    if (!commit_poll_is_before(s, time, *address))
        return time;
    *address = mintree_address(&s->polls);
    return mintree_least(&s->polls);
}

/* Commits the earliest event. False: there is none. */
static bool commit_next(struct schedule *s)
{
    if (mintree_least(&s->polls) != VT_NEVER &&
        commit_poll_is_before(s, evq_next(s->q), evq_next_address(s->q))) {
        struct lp *lp = up_lp_at(s, mintree_address(&s->polls));
        if (!offload_paused(lp))
            lp_go_on_from_poll(lp);
        return true;
    }
    return evq_step(s->q, &s->present, &s->reached);
}

/* Commits the earliest event, unless a task that is out may cause an earlier one: then helps with that.
 * False: there is neither. */
static bool commit_or_help(struct schedule *s)
{
    bool out = s->workers && workers_busy(s->workers);
    if (!out && s->max_time == VT_NEVER)
        return commit_next(s);
    for (struct task *t; out && (t = workers_take(s->workers));)
        offload_take_back(t);
    uint32_t address;
    vtime next = next_event(s, &address);
    if (out && !workers_allow(s->workers, next, address)) {
        s->unseen = LOOK_EVERY; /* it may have taken long */
        workers_advance(s->workers, next, address);
        return true;
    }
    if (next == VT_NEVER)
        return out && workers_busy(s->workers);
    if (next > s->max_time) {
        up_end_at_limit(s);
        return !s->stop; /* there is another limit now */
    }
    return commit_next(s);
}

/* Flattened: after a switch to a program and back no processor foresees where a function returns to. */
__attribute__((flatten)) static void commit_events(struct schedule *s)
{
    uint32_t left = 1;
    while (!s->stop && commit_or_help(s)) {
        if (--left && s->unseen < LOOK_EVERY)
            continue;
        s->look(s->look_ctx);
        left = LOOK_EVERY;
    }
}

/* The machine has been stopped: programs paused at polls come as far as the others. */
static void catch_up(struct schedule *s)
{
    for (uint32_t i = 0; s->stop && i < s->polls.room; i++)
        if (s->polls.time[i] != VT_NEVER)
            lp_catch_up(up_lp_at(s, i), s->stop_at.time);
}

static void *thread_begins(void *ctx)
{
    const struct engine_threads *t = ctx;
    return t->begin();
}

static bool thread_runs(void *own, struct task *t)
{
    (void)own;
    return offload_run(t);
}

void engine_hold(struct schedule *s)
{
    if (s->workers)
        workers_halt(s->workers);
}

void engine_release(struct schedule *s)
{
    if (s->workers)
        workers_go_on(s->workers);
}

vtime engine_bound(const struct schedule *s)
{
    return s->workers ? workers_bound(s->workers) : VT_NEVER;
}

struct workers_stats engine_run(struct schedule *s, const struct engine_threads *threads)
{
    const struct workers_calls calls = {(void *)threads, thread_begins, thread_runs, threads->end,
                                        threads->hurry};
    struct workers_stats stats = {0};
    s->resumes[0] = lp_go_on, s->resumes[1] = lp_woken;
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
