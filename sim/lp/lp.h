/* lp.h - a node as a logical process: what has a clock of its own and changes only by its events
 * (Chandy & Misra 1979).
 *
 * Read this file first. The rules of time are sim/reference/reference.c, less than 300 lines without a
 * trick; sim/lp does the same faster.
 *
 * A program computes ahead of the machine. Its computing up to its next call, a compute segment, is
 * executed at once. The call is committed at its commit time, when the machine has committed all that comes
 * before in the total order. A program that handlers may interrupt computes up to its horizon only: the
 * earliest time at which anything may reach it. There it pauses at a poll, and goes on when all others have
 * come so far. Its lookahead, computing that is certain before its next call, tells how long nobody need
 * wait for it.
 *
 * A node is in one of these states (enum lp_state), and what happens to it has these effects (dispatch.c,
 * wake.c, deferral.c, block.c, offload.c):
 *
 *                 its commit     its poll     it is woken            system time     it is killed
 *                 time           time                                is taken
 *    computing    makes its      -            -                      commits later   is rolled back
 *                 call
 *    paused       -              computes on  catches up             catches up,     is rolled back
 *                                                                    goes on later
 *    offloaded    -              -            -                      commits later   its task is dropped
 *    blocks       blocked:       -            blocked; or, if what   commits later   is rolled back
 *    lazily       no event                    it waits for is there,
 *                                             an event at its
 *                                             commit time
 *    blocked      -              -            resumes if ready       idles less      has idled until then
 *    ended        -              -            -                      nobody's time   -
 *
 *    computing       the program has control on the coordinator, or its commit time is in the queue
 *    paused          at a poll; schedule.polls has the time at which the program goes on
 *    offloaded       a worker runs its task up to its next call. Only that worker may touch the clock (but
 *                    for `stolen`), memory, C library and errno of the program. The coordinator has all else:
 *                    mailbox, statistics, state
 *    blocks lazily   the node will block at its commit time, as far as is known; no event is queued for that
 *    blocked         the node waits in a call for a message, a handler or a time
 *
 * Calls are committed on the coordinator only, in the total order. So are library calls that show something
 * to the outside.
 *
 * System time. A message takes a computing node's processor for a while. That time is noted as stolen, and
 * the node's commit time or poll time is so much later. The horizon is never later than such a moment, so
 * that slices change nothing.
 *
 * Commit times without an event (of lazily blocked nodes, deferred calls and polls) have come when the
 * machine has reached a later moment. Where events follow each other in no time, the machine may come back
 * to a smaller address at the same time; so the latest moment counts, schedule.reached. A commit time
 * before it is put into the queue as an event (lp_is_passed). Polls need no such care: a program always
 * computes something before a poll. */
#ifndef LP_LP_H
#define LP_LP_H
#include "kernel/fiber.h"
#include "kernel/slow_assert.h"
#include "lp/schedule.h"

enum lp_state { LP_COMPUTING, LP_PAUSED, LP_OFFLOADED, LP_BLOCKS_LAZILY, LP_BLOCKED, LP_ENDED };

struct lp_clock {
    vtime now;        /* at the last synchronisation */
    uint64_t units;   /* cost units spent up to it */
    int64_t granted;  /* what *budget was set to then */
    vtime stolen;     /* system time not yet added to `now` */
    uint64_t unit_ps; /* of a cost unit; 0: no whole number. clock_set */
    bool runs;        /* the program computes, not in a call: it may have spent some */
};

/* In cost units of the clock; clock.h. */
struct lp_segment {
    uint64_t lookahead;  /* the program makes no call before; less than clock.units: it may at any time */
    uint64_t begun, end; /* when the program got control; the next slice boundary */
    uint64_t committed;  /* when it last got control with all earlier events committed */
};

/* Where a program was at a slice boundary. */
struct lp_place {
    uint64_t units;
    uintptr_t at;   /* behind the poll */
    uint64_t since; /* the first of the places in a row, in this segment, that are the same; */
    uint32_t same;  /* how many they are, with this one */
};
enum { LP_PLACES = 16, LP_LOOP = 4 };

/* The latest places, a ring. Most programs never come to a slice boundary. */
struct lp_places {
    struct lp_place place[LP_PLACES];
    uint32_t count; /* of all */
};

/* A program whose task may run on any thread: offload.c. */
struct lp_offload {
    struct task task;
    uint64_t last;       /* set of calls: the last */
    uint64_t long_after; /* set of calls: those behind which the program computed for long the last time */
};

/* What most calls need comes first, in the order of the lines of the cache. */
struct lp {
    struct lp_clock clock;
    struct schedule *schedule;
    uint32_t address;        /* on the network: the node's number, except for the host's */
    enum lp_state state : 8; /* changes by lp_become() */
    /* Up to here a message needs it: node/node.h. */
    bool drains;         /* the program goes on when no deferred call is left, whatever its time */
    bool crashed;        /* to be reported at its commit time */
    bool interruptible;  /* by a handler: the program computes up to its horizon only */
    bool task_paused;    /* its task ended at a poll, and is to be gone on with */
    int saved_errno;     /* of the program, while it does not run */
    vtime scheduled_at;  /* the queue has an event for its deferred calls then; 0: none */
    vtime blocked_since; /* VT_NEVER: not blocked since its call began */
    int64_t *budget;    /* in its program: units to spend until a poll gives control back. NULL: no program */
    int64_t *lookahead; /* in its program: what *budget is at its next call, at most */
    struct lp_segment segment;
    vtime until; /* not 0: the program catches up, or is offloaded, until this time only */
    struct fiber fiber;
    vtime poll_time; /* paused at a poll: the clock's time */
    vtime arrived;   /* offloaded, and at its next call: its time; or of the poll at `until` */
    struct lp_offload offload;
    uint64_t clock_hz;
    struct lp_places *places; /* NULL: none yet */
};

/* May a node that is in one state be in the other next? */
bool lp_may_become(enum lp_state now, enum lp_state next);
static inline void lp_become(struct lp *lp, enum lp_state next)
{
    slow_assert(lp_may_become(lp->state, next));
    lp->state = next;
}
/* Has the node a program that is not at rest in a call, as far as the machine has come? */
static inline bool lp_computes(const struct lp *lp)
{
    return lp->state < LP_BLOCKED;
}

/* A node at an address, without a program; its state is LP_COMPUTING. */
void lp_begin(struct lp *lp, struct schedule *s, uint32_t address);
/* The words through which its program and its clock share the count (nx_api/contract/program_image.h). */
void lp_bind(struct lp *lp, int64_t *budget, int64_t *lookahead);
/* It has no program any more; what was noted of it is freed. */
void lp_unbind(struct lp *lp);
/* The program has ended, or there is none. */
void lp_end(struct lp *lp);
/* Up to the node's moment at `now`, which is included. */
static inline struct instant lp_up_to(const struct lp *lp, vtime now)
{
    return (struct instant){now, lp->address + 1};
}

/* Has the machine reached a moment later than the node's at t? */
static inline bool lp_is_passed(const struct lp *lp, vtime t)
{
    return instant_before(t, lp->address, lp->schedule->reached);
}
#endif
