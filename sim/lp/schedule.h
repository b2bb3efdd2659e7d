/* schedule.h - what all logical processes of one machine share: the events to come, and how far the machine
 * has come.
 *
 * The next event is the earliest of two: of the queue, and of the polls, which are the times at which nodes
 * paused at a poll go on. It is committed when no task that is offloaded may still cause an earlier one.
 *
 * sim/machine sets what is marked "machine" before the first event; all else is sim/lp's. */
#ifndef LP_SCHEDULE_H
#define LP_SCHEDULE_H
#include "kernel/evq.h"
#include "kernel/mintree.h"
#include "kernel/prefetch.h"
#include "kernel/workers.h"
#include "net/protocol.h"

/* Why the machine stops before its programs have ended. */
enum stop { STOP_NOT, STOP_FAILED, STOP_KILLED, STOP_VIRTUAL_TIME, STOP_WALL_TIME, STOP_INTERRUPTED };

struct schedule {
    struct evq *q;             /* machine */
    struct mintree polls;      /* by address: when a node paused at a poll resumes; lp/dispatch.c */
    struct instant present;    /* the moment committed last: an event's, or a call's that needed none */
    struct instant reached;    /* the latest moment committed, `present` or one before: lp.h */
    struct protocol *protocol; /* machine */
    struct workers *workers;   /* NULL: one thread */
    evq_fire *resumes[2];      /* events upon which a program may run, for loading ahead */
    bool loads_ahead;          /* machine: the caches do not hold all nodes: prefetch_coming.h */

    enum stop stop;
    struct instant stop_at; /* STOP_FAILED: the failed program's moment; STOP_VIRTUAL_TIME: the limit */
    uint32_t switches;      /* to programs, modulo 2^32, where anything is loaded ahead */
    uint32_t unseen;        /* calls since look() was called last */

    /* Threads read what follows all the time: apart from what the coordinator writes. */
    char apart[CACHE_LINE];
    vtime max_time; /* machine. VT_NEVER: none */
    /* machine: not 0: computing is stopped at least so often, for tests; changes no result */
    vtime longest_slice;
    void (*look)(void *ctx); /* machine: at host time and signals, which may stop the machine */
    void *look_ctx;          /* machine */
};

/* The first time past the limit of virtual time. */
static inline vtime schedule_end_of_time(const struct schedule *s)
{
    return s->max_time == VT_NEVER ? VT_NEVER : s->max_time + 1;
}

/* Commits the moment (time, address), which is not before `reached`, without an event. */
static inline void schedule_commit(struct schedule *s, vtime time, uint32_t address)
{
    s->present = s->reached = (struct instant){time, address};
}

/* So many calls have been made without a look at host time and signals. True: it is time to look. */
static inline bool schedule_has_not_looked(struct schedule *s, uint32_t calls)
{
    enum { MOST_UNSEEN = 4096 };
    return (s->unseen += calls) > MOST_UNSEEN;
}

/* The same, and looks then; true if so. */
static inline bool schedule_look_after(struct schedule *s, uint32_t calls)
{
    if (!s->look || !schedule_has_not_looked(s, calls))
        return false;
    s->unseen = 0;
    s->look(s->look_ctx);
    return true;
}

/* Stops the machine: the next event is not committed any more. */
static inline void schedule_stop(struct schedule *s, enum stop why, struct instant at)
{
    s->stop = why;
    s->stop_at = at;
}
#endif
