/* waitfor_cause.c - the cause of each wait. What a node's own mailbox shows comes first: a message that does
 * not match, one that another receive has taken, a handler that may not run. A cycle is often no more than
 * what follows from such a fault. */
#include "nx_api/waitfor/waitfor_parts.h"

/* --- what is to be seen on the node itself --- */

static bool is_handler_due(const struct waitfor_node *n)
{
    return n->due && (n->masked || n->in_handler);
}

bool waitfor_concerns(const struct waitfor_node *n, const struct waitfor_message *m)
{
    return !waitfor_operation(m->type) &&
           (!waitfor_is_collective(m->pid) || waitfor_is_collective(n->select.pid));
}

/* Is the message of the kind for which the node waits: a program's own, or a collective's? */
static bool is_alike(const struct waitfor_node *n, const struct waitfor_message *m)
{
    return !waitfor_operation(m->type) && !m->of_window &&
           waitfor_is_collective(m->pid) == waitfor_is_collective(n->select.pid);
}

/* Is the message selected but for its sender; but for its type? */
static bool is_wrong_node(const struct waitfor_node *n, const struct waitfor_message *m)
{
    return is_alike(n, m) && waitfor_type_selected(n->select.typesel, m->type) &&
           !waitfor_selects(&n->select, m->type, m->from, m->pid);
}

/* (What a node has sent to itself is for another of its receives.) */
static bool is_wrong_type(const struct waitfor_node *n, const struct waitfor_message *m)
{
    return is_alike(n, m) && m->from != n->number && !waitfor_type_selected(n->select.typesel, m->type) &&
           (n->select.node == WAITFOR_ANY || n->select.node == m->from);
}

static bool any_message(const struct waitfor_node *n,
                        bool (*is)(const struct waitfor_node *n, const struct waitfor_message *m))
{
    for (size_t i = 0; i < n->message_count; i++)
        if (is(n, &n->messages[i]))
            return true;
    return false;
}

static bool same(const struct waitfor_select *a, const struct waitfor_select *b)
{
    return a->typesel == b->typesel && a->node == b->node && a->pid == b->pid;
}

/* May a message that a receive took have been meant for this node's call? Not if the call takes any type and
 * the receive one: that was meant for the receive. */
static bool may_have_missed(const struct waitfor_node *n, const struct waitfor_taken *t)
{
    if (t->fate == WAITFOR_FLUSHED || t->fate == WAITFOR_DISCARDED)
        return true;
    if (n->select.typesel < 0 && t->by.typesel >= 0)
        return false;
    return t->fate == WAITFOR_HANDLED || !same(&t->by, &n->select);
}

/* What the same receive has taken before was for it; what others have taken was not for them, perhaps. */
const struct waitfor_taken *waitfor_taken_away(const struct waitfor_node *n)
{
    for (size_t i = n->taken_count; i-- > 0;) {
        const struct waitfor_taken *t = &n->taken[i];
        if (waitfor_selects(&n->select, t->type, t->from, t->pid) && may_have_missed(n, t))
            return t;
    }
    return NULL;
}

const struct waitfor_receive *waitfor_held_by(const struct waitfor_node *n)
{
    for (size_t i = 0; i < n->receive_count; i++) {
        const struct waitfor_receive *r = &n->receives[i];
        if (r->filled && !r->has_handler && waitfor_selects(&n->select, r->type, r->from, WAITFOR_ANY))
            return r;
    }
    return NULL;
}

/* A probe's message that cannot come whole. */
static bool is_held_back(const struct waitfor_node *n, const struct waitfor_message *m)
{
    return m->held_back && waitfor_selects(&n->select, m->type, m->from, m->pid);
}

/* WAITFOR_CAUSES: nothing is to be seen. */
static enum waitfor_cause of_mailbox(const struct waitfor_node *n)
{
    if (any_message(n, is_held_back))
        return WAITFOR_BUFFERS_FULL;
    if (n->in_window) /* what the library has received was for the library */
        return WAITFOR_CAUSES;
    if (waitfor_held_by(n) || waitfor_taken_away(n))
        return WAITFOR_TAKEN;
    if (any_message(n, is_wrong_node))
        return WAITFOR_WRONG_NODE;
    return any_message(n, is_wrong_type) ? WAITFOR_WRONG_TYPE : WAITFOR_CAUSES;
}

/* --- what ended nodes have left --- */

/* Has a node ended, but for the host? All global operations wait for it. */
static bool some_has_ended(const struct waitfor *w)
{
    for (uint32_t i = 0; i < w->count; i++)
        if (!w->nodes[i].is_host && !waitfor_lives(&w->nodes[i]))
            return true;
    return false;
}

static bool waits_for_ended(const struct waitfor *w, const struct waitfor_node *n, bool some_ended)
{
    if (n->operation)
        return some_ended;
    if (n->who == WAITFOR_ONE_NODE)
        return n->what != WAITFOR_END && !waitfor_lives(&w->nodes[n->whom]);
    return n->who == WAITFOR_NOBODY && n->what == WAITFOR_MESSAGE && !waitfor_lacks_host(w, n);
}

/* In a collective of MPI's, is the awaited rank still to come to the collective, or to the step that its
 * message is of? What other ranks have sent is then for later steps, and no fault. */
static bool is_late_in_collective(const struct waitfor *w, const struct waitfor_node *n)
{
    if (!waitfor_in_collective(n) || n->who != WAITFOR_ONE_NODE)
        return false;
    const struct waitfor_node *whom = &w->nodes[n->whom];
    return !waitfor_lives(whom) ||
           (whom->state == WAITFOR_WAITS && whom->what == WAITFOR_MESSAGE &&
            (whom->select.pid != n->select.pid || whom->select.typesel == n->select.typesel));
}

/* --- the cause --- */

static enum waitfor_cause local_cause(const struct waitfor *w, const struct waitfor_node *n, bool some_ended)
{
    if (is_handler_due(n))
        return WAITFOR_MASKED;
    bool shows = n->what == WAITFOR_MESSAGE && !n->operation && !is_late_in_collective(w, n);
    enum waitfor_cause c = shows ? of_mailbox(n) : WAITFOR_CAUSES;
    if (c == WAITFOR_CAUSES && waits_for_ended(w, n, some_ended))
        c = WAITFOR_NODE_HAS_ENDED;
    return c == WAITFOR_CAUSES && n->what == WAITFOR_BUFFER ? WAITFOR_BUFFERS_FULL : c;
}

static enum waitfor_cause graph_cause(const struct waitfor_node *n, bool knot)
{
    if (n->in_cycle || n->in_circle)
        return WAITFOR_CYCLE;
    if (n->who == WAITFOR_ONE_NODE || n->who == WAITFOR_ALL_NODES || n->what == WAITFOR_FILE)
        return WAITFOR_BEHIND;
    return knot && n->who == WAITFOR_ANY_NODE ? WAITFOR_KNOT : WAITFOR_ORPHAN;
}

/* Two or more that any other could free, and no fault of a single one's: a knot. A single one is what all
 * others wait for in the end. */
static bool is_knot_the_cause(const struct waitfor *w)
{
    uint32_t any = 0, local = 0;
    for (uint32_t i = 0; i < w->count; i++) {
        const struct waitfor_node *n = &w->nodes[i];
        if (n->state != WAITFOR_WAITS)
            continue;
        any += n->who == WAITFOR_ANY_NODE;
        local += n->cause != WAITFOR_CAUSES;
    }
    return w->knot && any > 1 && local == 0;
}

void waitfor_find_causes(struct waitfor *w)
{
    bool some_ended = some_has_ended(w);
    for (uint32_t i = 0; i < w->count; i++)
        if (w->nodes[i].state == WAITFOR_WAITS)
            w->nodes[i].cause = local_cause(w, &w->nodes[i], some_ended);
    bool knot = is_knot_the_cause(w);
    for (uint32_t i = 0; i < w->count; i++) {
        struct waitfor_node *n = &w->nodes[i];
        if (n->state == WAITFOR_WAITS && n->cause == WAITFOR_CAUSES)
            n->cause = graph_cause(n, knot);
    }
}

const char *waitfor_cause_name(enum waitfor_cause c)
{
    static const char *const NAMES[WAITFOR_CAUSES] = {
        [WAITFOR_WRONG_TYPE] = "wrong type",
        [WAITFOR_WRONG_NODE] = "wrong node",
        [WAITFOR_TAKEN] = "message taken",
        [WAITFOR_MASKED] = "handler masked",
        [WAITFOR_BUFFERS_FULL] = "buffers full",
        [WAITFOR_NODE_HAS_ENDED] = "node has ended",
        [WAITFOR_CYCLE] = "cycle",
        [WAITFOR_KNOT] = "knot",
        [WAITFOR_BEHIND] = "behind others",
        [WAITFOR_ORPHAN] = "orphan",
    };
    return NAMES[c];
}
