/* wait_groups.c - see wait_groups.h. */
#include "lab/why/wait_groups.h"
#include <search.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

/* Texts of places are equal if their addresses are. */
static int compare(const void *a, const void *b)
{
    const struct wait_group *x = a, *y = b;
#define BY(member)                                                                                           \
    if (x->member != y->member)                                                                              \
        return x->member < y->member ? -1 : 1;
    BY(cause)
    BY(doing)
    BY(call)
    BY(sent)
    BY(leaves)
#undef BY
    return 0;
}

/* The group of a part of a wait, without sums. */
static struct wait_group group_of(struct why *w, const struct wait_part *p)
{
    const struct trace *t = w->t;
    const struct trace_message *m = p->message == TRACE_NONE ? NULL : &t->messages[p->message];
    bool by_partner = p->cause == WAIT_LATE_SENDER || p->cause == WAIT_LATE_RECEIVER;
    struct wait_group g = {.cause = p->cause,
                           .doing = by_partner ? p->doing : TRACE_COMPUTING,
                           .call = places_call(w->places, t->waits[p->wait].call),
                           .sent = "",
                           .partner = p->partner,
                           .block = TRACE_NONE,
                           .last_node = TRACE_NONE};
    if (!m)
        return g;
    g.leaves = m->from == p->node && m->to != p->node;
    if (g.leaves)
        return g;
    g.type = g.last_type = m->type, g.has_type = true, g.pid = m->pid;
    if (m->sending != TRACE_NONE)
        g.sent = places_call(w->places, m->sending);
    return g;
}

static void add(struct wait_group *g, const struct wait_part *p, const struct wait_group *like)
{
    g->idle += p->idle;
    g->waits++;
    if (p->node != g->last_node) /* parts come node by node */
        g->nodes++;
    g->last_node = p->node;
    g->partners = g->partners || p->partner != g->partner;
    if (like->pid != g->pid)
        g->pid = 0;
    if (like->type < g->type)
        g->type = like->type;
    if (like->type > g->last_type)
        g->last_type = like->type;
    if (p->idle > g->longest_idle)
        g->longest_idle = p->idle, g->longest = p->wait;
    if (p->cause == WAIT_CHANNEL && p->idle > g->longest_block)
        g->longest_block = p->idle, g->block = p->block;
}

static int by_idle(const void *a, const void *b)
{
    const struct wait_group *x = a, *y = b;
    int order;
    if (x->idle != y->idle)
        return x->idle > y->idle ? -1 : 1;
    if (x->cause != y->cause)
        return (int)x->cause - (int)y->cause;
    if ((order = strcmp(x->call, y->call)) || (order = strcmp(x->sent, y->sent)))
        return order;
    return x->doing != y->doing ? (int)x->doing - (int)y->doing : (int)x->leaves - (int)y->leaves;
}

static void collect(const void *node, VISIT which, void *closure)
{
    struct why *w = closure;
    if (which == postorder || which == leaf)
        w->groups[w->group_count++] = **(struct wait_group *const *)node;
}

void wait_groups_find(struct why *w)
{
    void *tree = NULL;
    size_t count = 0;
    for (size_t i = 0; i < w->causes.count; i++) {
        struct wait_group key = group_of(w, &w->causes.parts[i]), **found = tfind(&key, &tree, compare);
        if (!found) {
            struct wait_group *g = xcalloc(1, sizeof *g);
            *g = key;
            found = xchecked(tsearch(g, &tree, compare));
            count++;
        }
        add(*found, &w->causes.parts[i], &key);
    }
    w->groups = xcalloc(count, sizeof *w->groups);
    twalk_r(tree, collect, w);
    tdestroy(tree, free);
    qsort(w->groups, w->group_count, sizeof *w->groups, by_idle);
}
