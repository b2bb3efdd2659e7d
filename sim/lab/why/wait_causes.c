/* wait_causes.c - see wait_causes.h. */
#include "lab/why/wait_causes.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

static const struct {
    const char *name, *key;
} CAUSES[WAIT_CAUSES] = {
    [WAIT_LATE_SENDER] = {"late sender", "late_sender"},
    [WAIT_LATE_RECEIVER] = {"late receiver", "late_receiver"},
    [WAIT_HANDLER] = {"handler busy", "handler_busy"},
    [WAIT_OTHER_MESSAGES] = {"system: other messages", "other_messages"},
    [WAIT_CHANNEL] = {"channel busy", "channel_busy"},
    [WAIT_NETWORK] = {"network", "network"},
    [WAIT_MESSAGE] = {"message handled", "message_handled"},
    [WAIT_DISK] = {"disk", "disk"},
    [WAIT_NEVER] = {"nothing came", "nothing_came"},
    [WAIT_UNKNOWN] = {"services, or unknown", "unknown"},
};

const char *wait_cause_name(enum wait_cause c)
{
    return CAUSES[c].name;
}

const char *wait_cause_key(enum wait_cause c)
{
    return CAUSES[c].key;
}

/* An interval in which the waiting processor was idle. */
struct rest {
    vtime begin, end;
};

/* A wait that is being divided. */
struct division {
    const struct trace *t;
    struct piece_map *map;
    const struct wait_enders *enders;
    struct wait_causes *causes;
    struct message_way way;
    struct rest *rests; /* of the wait, in the order of time */
    size_t rest_count, rest_room;
    int32_t wait, message, partner;
    int32_t block; /* the longest so far */
    vtime block_idle;
    vtime idle[WAIT_CAUSES][TRACE_STATES]; /* so far */
};

/* --- when the processor was idle --- */

static void add_rest(struct division *d, vtime begin, vtime end)
{
    if (d->rest_count == d->rest_room) {
        d->rest_room = d->rest_room ? 2 * d->rest_room : 16;
        d->rests = xreallocarray(d->rests, d->rest_room, sizeof *d->rests);
    }
    d->rests[d->rest_count++] = (struct rest){begin, end};
}

/* The node's books count works of the system one after the other, though moving bytes goes on while
 * messages are handled: so a wait may have less rest than its pieces say. What is too much, at most the sum
 * of the rests, was at its end. */
static void take_rest(struct division *d, vtime much)
{
    while (much) {
        assert(d->rest_count);
        struct rest *last = &d->rests[d->rest_count - 1];
        vtime takes = vt_min(much, last->end - last->begin);
        last->end -= takes, much -= takes;
        d->rest_count -= last->begin == last->end;
    }
}

static int by_begin(const void *a, const void *b)
{
    const struct rest *x = a, *y = b;
    return x->begin < y->begin ? -1 : x->begin > y->begin;
}

/* And a wait may have more: the books counted the system's work before the wait. */
static void give_rest(struct division *d, const struct trace_wait *w, vtime much)
{
    const struct trace_piece *first = piece_map_from(d->map, w->node, w->begin);
    const struct trace_piece *p = piece_map_before(d->map, w->node, w->end);
    for (; much && p && p >= first; p--) {
        vtime begin = vt_max(p->begin, w->begin), end = vt_min(p->end, w->end);
        if (p->state == TRACE_WAITING || begin >= end)
            continue;
        vtime gives = vt_min(much, end - begin);
        add_rest(d, end - gives, end);
        much -= gives;
    }
    if (d->rest_count)
        qsort(d->rests, d->rest_count, sizeof *d->rests, by_begin);
}

static vtime rest_of_all(const struct division *d)
{
    vtime sum = 0;
    for (size_t i = 0; i < d->rest_count; i++)
        sum += d->rests[i].end - d->rests[i].begin;
    return sum;
}

/* Finds the rests of the wait: in all as long as the books say. Of a wait that is cut by the trace's
 * limits, they are as long as the pieces say. */
static void find_rests(struct division *d)
{
    const struct trace_wait *w = &d->t->waits[d->wait];
    const struct trace_piece *p = piece_map_from(d->map, w->node, w->begin),
                             *end = piece_map_end(d->map, w->node);
    d->rest_count = 0;
    for (; p && p < end && p->begin < w->end; p++)
        if (p->state == TRACE_WAITING && p->wait == d->wait)
            add_rest(d, p->begin, p->end);
    vtime sum = rest_of_all(d);
    if (w->begin < d->t->from || w->end > d->t->to)
        return;
    if (sum > w->idle)
        take_rest(d, sum - w->idle);
    else
        give_rest(d, w, w->idle - sum);
}

/* Of the time from a to b: in which the wait's processor was idle. */
static vtime idle_in(const struct division *d, vtime a, vtime b)
{
    size_t low = 0, high = d->rest_count;
    vtime idle = 0;
    while (low < high) { /* the first that ends after a */
        size_t middle = (low + high) / 2;
        if (d->rests[middle].end > a)
            high = middle;
        else
            low = middle + 1;
    }
    for (; a < b && low < d->rest_count && d->rests[low].begin < b; low++)
        idle += vt_min(b, d->rests[low].end) - vt_max(a, d->rests[low].begin);
    return idle;
}

/* --- dividing --- */

/* The time from a to b is what the partner's doing made of it. */
static void charge_doing(struct division *d, enum wait_cause late, int32_t partner, vtime a, vtime b)
{
    if (a >= b)
        return;
    if (partner == TRACE_NONE || !d->t->nodes[partner].traced) {
        d->idle[late][TRACE_COMPUTING] += idle_in(d, a, b);
        return;
    }
    const struct trace_piece *p = piece_map_from(d->map, partner, a), *end = piece_map_end(d->map, partner);
    for (; p && p < end && p->begin < b; p++) {
        bool stolen = p->state == TRACE_IN_SYSTEM && !piece_enters_handler(p);
        enum wait_cause cause = stolen ? WAIT_OTHER_MESSAGES : p->in_handler ? WAIT_HANDLER : late;
        enum trace_state doing = cause == late ? p->state : TRACE_COMPUTING;
        d->idle[cause][doing] += idle_in(d, vt_max(a, p->begin), vt_min(b, p->end));
    }
}

static void charge(struct division *d, enum wait_cause cause, vtime a, vtime b)
{
    d->idle[cause][TRACE_COMPUTING] += idle_in(d, a, b);
}

static void charge_channel(struct division *d, const struct way_leg *leg, vtime a)
{
    vtime idle = idle_in(d, a, leg->end);
    d->idle[WAIT_CHANNEL][TRACE_COMPUTING] += idle;
    if (idle > d->block_idle)
        d->block_idle = idle, d->block = leg->block;
}

static void charge_leg(struct division *d, const struct way_leg *leg, vtime begin)
{
    vtime a = vt_max(leg->begin, begin);
    if (leg->class == WHY_CHANNEL)
        charge_channel(d, leg, a);
    else if (leg->class == WHY_GRANT)
        charge_doing(d, WAIT_LATE_RECEIVER, leg->node, a, leg->end);
    else
        charge(d,
               leg->class == WHY_OTHER_MESSAGES ? WAIT_OTHER_MESSAGES
               : leg->class == WHY_MESSAGE      ? WAIT_MESSAGE
                                                : WAIT_NETWORK,
               a, leg->end);
}

/* Divides along the way of the message that ended the wait. */
static void along_way(struct division *d, const struct wait_ender *e)
{
    const struct trace_wait *w = &d->t->waits[d->wait];
    charge(d, WAIT_OTHER_MESSAGES, e->at, w->end); /* it was there, and the program could not go on yet */
    message_way_find(d->enders, d->map, e->message, e->leaves, e->at, &d->way);
    for (size_t i = 0; i < d->way.count && d->way.legs[i].end > w->begin; i++)
        charge_leg(d, &d->way.legs[i], w->begin);
    d->partner = e->leaves ? d->t->messages[e->message].to : d->way.node;
    if (e->leaves || d->way.node == TRACE_NONE)
        charge(d, WAIT_UNKNOWN, w->begin, d->way.sent);
    else
        charge_doing(d, WAIT_LATE_SENDER, d->way.node, w->begin, d->way.sent);
}

static void add_part(struct wait_causes *c, struct wait_part part)
{
    if (!part.idle)
        return;
    c->parts = xgrown(c->parts, c->count, sizeof *c->parts);
    c->parts[c->count++] = part;
    c->by_cause[part.cause] += part.idle;
}

static void add_parts(struct division *d)
{
    for (int cause = 0; cause < WAIT_CAUSES; cause++)
        for (int doing = 0; doing < TRACE_STATES; doing++)
            add_part(d->causes, (struct wait_part){.cause = (enum wait_cause)cause,
                                                   .doing = (enum trace_state)doing,
                                                   .wait = d->wait,
                                                   .node = d->t->waits[d->wait].node,
                                                   .partner = d->partner,
                                                   .message = d->message,
                                                   .block = cause == WAIT_CHANNEL ? d->block : TRACE_NONE,
                                                   .idle = d->idle[cause][doing]});
}

static bool lasts_to_the_end(const struct trace *t, const struct trace_wait *w)
{
    const struct trace_call *c = &t->calls[w->call];
    return (c->unfinished && w->end >= c->end) || w->end > t->to;
}

static void divide(struct division *d, int32_t wait)
{
    const struct trace_wait *w = &d->t->waits[wait];
    const struct trace_call *c = &d->t->calls[w->call];
    struct wait_ender e = wait_enders_of(d->enders, d->map, wait);
    d->wait = wait, d->message = e.message, d->partner = d->block = TRACE_NONE, d->block_idle = 0;
    memset(d->idle, 0, sizeof d->idle);
    find_rests(d);
    d->causes->idle += rest_of_all(d);
    if (d->t->classes[c->name] == TRACE_FILES)
        charge(d, WAIT_DISK, w->begin, w->end);
    else if (e.message != TRACE_NONE)
        along_way(d, &e);
    else
        charge(d, lasts_to_the_end(d->t, w) ? WAIT_NEVER : WAIT_UNKNOWN, w->begin, w->end);
    add_parts(d);
}

static void divide_node(struct division *d, int32_t node)
{
    const struct trace_node *n = &d->t->nodes[node];
    for (int32_t i = 0; i < n->waits; i++)
        divide(d, n->first_wait + i);
}

/* The promise of wait_causes.h. */
static void check(const struct wait_causes *c)
{
    vtime_sum sum = 0;
    for (int i = 0; i < WAIT_CAUSES; i++)
        sum += c->by_cause[i];
    assert(sum == c->idle);
    (void)sum;
}

struct wait_causes wait_causes_find(const struct trace *t, struct piece_map *map, const struct wait_enders *e,
                                    const struct trace_selection *only)
{
    struct wait_causes causes = {0};
    struct division d = {.t = t, .map = map, .enders = e, .causes = &causes};
    for (int32_t i = 0; i < t->node_count; i++)
        if (t->nodes[i].traced && (!only || trace_selects(t, only, i)))
            divide_node(&d, i);
    free(d.way.legs);
    free(d.rests);
    check(&causes);
    return causes;
}
