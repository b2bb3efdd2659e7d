/* upcalls_ahead.c - the operating system's answers to lp/upcalls.h: those that only an engine needs which
 * computes ahead. */
#include "kernel/prefetch.h"
#include "lp/upcalls.h"
#include "node/system.h"
#include "os/deferred.h"
#include "os/isolate.h"

struct lp *up_lp_at(struct schedule *s, uint32_t address)
{
    return &node_at(system_of(s), address)->lp;
}

/* --- deferred calls --- */

bool up_has_deferred(const struct lp *lp)
{
    return node_of(lp)->deferred.count > 0;
}

void up_commit_deferred(struct lp *lp, struct instant before)
{
    deferred_commit_until(node_of(lp), before);
}

vtime up_next_deferred(const struct lp *lp, void **sends)
{
    struct message *m = NULL;
    vtime t = deferred_next(node_of(lp), &m);
    *sends = m;
    return t;
}

vtime up_last_deferred(const struct lp *lp)
{
    return deferred_last(node_of(lp));
}

void up_deferred_may_select(struct lp *lp)
{
    deferred_may_select(node_of(lp));
}

void up_roll_back_deferred(struct lp *lp)
{
    deferred_roll_back(node_of(lp));
}

void up_drop_deferred(struct lp *lp)
{
    deferred_undo(node_of(lp));
}

void *up_nest(struct schedule *s)
{
    return isolate_keep(system_of(s));
}

void up_unnest(struct schedule *s, void *outer)
{
    isolate_back_to(system_of(s), outer);
}

/* --- loading ahead (inlined: see prefetch.h) --- */

static inline __attribute__((always_inline)) void load(const void *from, const void *end)
{
    for (const char *p = from; p < (const char *)end; p += CACHE_LINE)
        __builtin_prefetch(p, 1);
}

/* GCC takes a function that only loads ahead for one without effect, and drops its calls. */
static inline __attribute__((always_inline)) void keep(void)
{
    __asm__ volatile("");
}

void up_prefetch_node(const struct lp *lp)
{
    enum { CALLS = 2 };
    const struct node *n = node_of(lp);
    load((const char *)n + CACHE_BLOCK, &n->lp.fiber.size);
    load(&n->wait, &n->stats.handlers);
    load(n->calls, &n->calls[CALLS]);
    keep();
}

static uint32_t ids_in_use(const struct node *n)
{
    return n->mailbox.ids.used < IDS_BLOCK ? n->mailbox.ids.used : IDS_BLOCK;
}

/* The first ids are in use, most often. */
void up_prefetch_receives(const struct lp *lp)
{
    const struct node *n = node_of(lp);
    for (uint32_t i = 0; i < ids_in_use(n); i++)
        prefetch_pair(&n->mailbox.ids.first->ids[i]);
    prefetch_pair(n->receive.m);
    __builtin_prefetch(n->stats.waits.list, 1);
    keep();
}

void up_prefetch_messages(const struct lp *lp)
{
    const struct node *n = node_of(lp);
    for (uint32_t i = 0; i < ids_in_use(n); i++)
        prefetch_pair(n->mailbox.ids.first->ids[i].receive.m);
    keep();
}

/* Of the stack: from a program's call to the switch, some functions. Beside its counter lie its other small
 * variables, and where it has its calls' addresses. */
void up_prefetch_program(const struct lp *lp)
{
    enum { LINE = CACHE_LINE, STACK = 7 * LINE, BESIDE = 2 * LINE };
    load((const char *)lp->budget - BESIDE, (const char *)lp->budget + BESIDE + LINE);
    const char *innermost = fiber_innermost(&lp->fiber);
    load(innermost, innermost + STACK);
    keep();
}
