/* test_why.c - the critical path and the causes of waits: of traces whose answers are known, of random
 * programs whose longest path is found by trying all paths, and of random traces. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>

#include <stdio.h>
#include <string.h>
#include "lab/why/critical_path.h"
#include "lab/why/wait_causes.h"
#include "made_trace.h"

/* What is found in a trace. */
struct found {
    struct piece_map map;
    struct wait_enders enders;
    struct path path;
    struct wait_causes causes;
};

static struct found find(const struct trace *t)
{
    struct found f = {.map = piece_map_new(t), .enders = wait_enders_new(t)};
    f.path = path_find(t, &f.map, &f.enders);
    f.causes = wait_causes_find(t, &f.map, &f.enders, NULL);
    return f;
}

static void drop(struct trace *t, struct found *f)
{
    piece_map_free(&f->map);
    wait_enders_free(&f->enders);
    free(f->path.steps);
    free(f->causes.parts);
    for (int32_t i = 0; i < t->name_count; i++)
        free(t->names[i]);
    free(t->names), free(t->classes), free(t->nodes), free(t->calls), free(t->waits), free(t->handlers);
    free(t->systems), free(t->messages), free(t->blocks);
}

/* --- parts of traces that made_trace.h does not make --- */

static void made_system(struct trace *t, int32_t node, enum trace_task task, vtime begin, vtime end)
{
    struct trace_node *n = &t->nodes[node];
    if (!n->systems++)
        n->first_system = t->system_count;
    t->systems[t->system_count++] = (struct trace_system){begin, end, begin, node, task};
}

static int32_t made_handler(struct trace *t, int32_t node, vtime due, vtime begin, vtime end)
{
    struct trace_node *n = &t->nodes[node];
    if (!n->handlers++)
        n->first_handler = t->handler_count;
    t->handlers[t->handler_count] = (struct trace_handler){.due = due,
                                                           .begin = begin,
                                                           .end = end,
                                                           .entered = begin,
                                                           .left = end,
                                                           .node = node,
                                                           .message = TRACE_NONE,
                                                           .stack = TRACE_NONE};
    return t->handler_count++;
}

/* The last message added asks first. */
static void made_long(struct trace *t, vtime asked, vtime granted, vtime entered)
{
    struct trace_message *m = &t->messages[t->message_count - 1];
    m->is_long = true, m->asked = asked, m->granted = granted, m->entered = entered;
}

/* So long of the wait the processor was at rest: the system had it otherwise. */
static void made_idle(struct trace *t, int32_t wait, vtime idle)
{
    t->waits[wait].idle = idle;
}

static int32_t send(struct trace *t, int32_t node, vtime begin, vtime end)
{
    return made_call(t, node, "csend", TRACE_SENDS, 1, begin, end);
}

static int32_t receive(struct trace *t, int32_t node, vtime begin, vtime end)
{
    return made_call(t, node, "crecv", TRACE_RECEIVES, 1, begin, end);
}

/* --- what a trace must lead to --- */

/* A step of a path, or its end: length 0. */
struct expected {
    vtime length;
    enum why_class class;
    int32_t node;
};

static void is_path(const struct path *p, const struct expected *e)
{
    size_t i = 0;
    for (; i < p->count && e[i].length; i++) {
        const struct path_step *s = &p->steps[i];
        if (s->end - s->begin != e[i].length || s->class != e[i].class || s->node != e[i].node)
            fail_msg("step %zu, from %lu to %lu, node %d, is %s", i, (unsigned long)s->begin,
                     (unsigned long)s->end, s->node, why_class_name(s->class));
    }
    assert_int_equal(e[i].length, 0);
    assert_int_equal(i, p->count);
}

static void waited(const struct found *f, int32_t node, enum wait_cause cause, int32_t partner, vtime idle)
{
    vtime sum = 0;
    for (size_t i = 0; i < f->causes.count; i++) {
        const struct wait_part *p = &f->causes.parts[i];
        if (p->node == node && p->cause == cause && p->partner == partner)
            sum += p->idle;
    }
    if (sum != idle)
        fail_msg("node %d: %s: %lu, not %lu", node, wait_cause_name(cause), (unsigned long)sum,
                 (unsigned long)idle);
}

/* --- known answers --- */

/*      0         60    70  80    90   95  100
 * 0    computing | send |
 * 1      | wait 10 ............. sys | recv |     */
static void late_sender(void **state)
{
    (void)state;
    struct trace t = made_trace(2, 100);
    t.nodes[0].end = 70;
    int32_t s = send(&t, 0, 60, 70), r = receive(&t, 1, 10, 95);
    made_idle(&t, made_wait(&t, 10, 90), 70);
    made_system(&t, 1, TRACE_RECEIVING, 80, 90);
    made_message(&t, s, r, 1, 10, 70, 70, 80, 90);
    struct found f = find(&t);
    is_path(&f.path, (struct expected[]){{60, WHY_COMPUTING, 0},
                                         {10, WHY_CALLS, 0},
                                         {10, WHY_NETWORK, TRACE_NONE},
                                         {10, WHY_MESSAGE, 1},
                                         {5, WHY_CALLS, 1},
                                         {5, WHY_COMPUTING, 1},
                                         {0}});
    assert_int_equal(f.causes.idle, 70);
    waited(&f, 1, WAIT_LATE_SENDER, 0, 60);
    waited(&f, 1, WAIT_NETWORK, 0, 10);
    drop(&t, &f);
}

/* A long message whose receiver computes until 50: the path leads to the receiver, not to the sender. */
static void late_receiver(void **state)
{
    (void)state;
    struct trace t = made_trace(2, 90);
    t.nodes[0].end = 85;
    int32_t s = send(&t, 0, 10, 85);
    made_idle(&t, made_wait(&t, 12, 85), 68);
    int32_t r = receive(&t, 1, 50, 90);
    made_idle(&t, made_wait(&t, 50, 90), 35);
    made_system(&t, 0, TRACE_SENDING, 60, 65);
    made_system(&t, 1, TRACE_RECEIVING, 20, 25); /* it cannot answer the request */
    made_system(&t, 1, TRACE_RECEIVING, 85, 90);
    made_message(&t, s, r, 1, 1000, 12, 65, 85, 90);
    made_long(&t, 20, 50, 65);
    struct found f = find(&t);
    is_path(&f.path, (struct expected[]){{20, WHY_COMPUTING, 1},
                                         {5, WHY_OTHER_MESSAGES, 1},
                                         {25, WHY_COMPUTING, 1},
                                         {10, WHY_NETWORK, TRACE_NONE},
                                         {5, WHY_MESSAGE, 0},
                                         {20, WHY_NETWORK, TRACE_NONE},
                                         {5, WHY_MESSAGE, 1},
                                         {0}});
    waited(&f, 0, WAIT_NETWORK, 1, 8 + 10 + 20);
    waited(&f, 0, WAIT_LATE_RECEIVER, 1, 25);
    waited(&f, 0, WAIT_OTHER_MESSAGES, 1, 5);
    waited(&f, 1, WAIT_NETWORK, 0, 30);
    waited(&f, 1, WAIT_MESSAGE, 0, 5);
    drop(&t, &f);
}

/* The same with the receive posted at 5: now the sender is late, though all trips are the same. */
static void early_receiver(void **state)
{
    (void)state;
    struct trace t = made_trace(2, 90);
    t.nodes[0].end = 85;
    int32_t s = send(&t, 0, 10, 85);
    made_idle(&t, made_wait(&t, 12, 85), 68);
    int32_t r = receive(&t, 1, 5, 90);
    made_idle(&t, made_wait(&t, 5, 90), 60);
    made_system(&t, 0, TRACE_SENDING, 60, 65);
    made_system(&t, 1, TRACE_RECEIVING, 30, 50); /* of them the last 20 for the request */
    made_system(&t, 1, TRACE_RECEIVING, 85, 90);
    made_message(&t, s, r, 1, 1000, 12, 65, 85, 90);
    made_long(&t, 20, 50, 65);
    struct found f = find(&t);
    is_path(&f.path, (struct expected[]){{10, WHY_COMPUTING, 0},
                                         {2, WHY_CALLS, 0},
                                         {8, WHY_NETWORK, TRACE_NONE},
                                         {10, WHY_OTHER_MESSAGES, 1},
                                         {20, WHY_MESSAGE, 1},
                                         {10, WHY_NETWORK, TRACE_NONE},
                                         {5, WHY_MESSAGE, 0},
                                         {20, WHY_NETWORK, TRACE_NONE},
                                         {5, WHY_MESSAGE, 1},
                                         {0}});
    waited(&f, 1, WAIT_LATE_SENDER, 0, 7);
    waited(&f, 0, WAIT_LATE_RECEIVER, 1, 0);
    waited(&f, 0, WAIT_MESSAGE, 1, 20);
    waited(&f, 0, WAIT_OTHER_MESSAGES, 1, 10);
    drop(&t, &f);
}

static void channel_busy(void **state)
{
    (void)state;
    struct trace t = made_trace(4, 100);
    t.nodes[0].end = t.nodes[2].end = t.nodes[3].end = 10;
    int32_t s = send(&t, 0, 0, 10), r = receive(&t, 1, 0, 100);
    made_wait(&t, 0, 100);
    made_message(&t, s, r, 1, 10, 10, 70, 100, 100);
    made_block(&t, 3, 10, 40);
    made_block(&t, 5, 40, 70);
    struct found f = find(&t);
    is_path(&f.path, (struct expected[]){{10, WHY_CALLS, 0},
                                         {30, WHY_CHANNEL, TRACE_NONE},
                                         {30, WHY_CHANNEL, TRACE_NONE},
                                         {30, WHY_NETWORK, TRACE_NONE},
                                         {0}});
    assert_int_equal(f.path.steps[2].block, 1);
    waited(&f, 1, WAIT_CHANNEL, 0, 60);
    waited(&f, 1, WAIT_NETWORK, 0, 30);
    waited(&f, 1, WAIT_LATE_SENDER, 0, 10);
    drop(&t, &f);
}

/* Node 1 asks node 0, whose handler answers. The handler is due at 20; the program masks it until 30. */
static struct trace asking(int32_t *handler)
{
    struct trace t = made_trace(2, 100);
    t.nodes[0].end = 90;
    int32_t answer = send(&t, 0, 60, 70);
    t.calls[answer].in_handler = true;
    int32_t ask = send(&t, 1, 0, 5), r = receive(&t, 1, 5, 100);
    made_wait(&t, 5, 80);
    *handler = made_handler(&t, 0, 20, 30, 75);
    t.handlers[*handler].entered = 40;
    t.handlers[*handler].message = made_message(&t, ask, TRACE_NONE, 0, 10, 5, 5, 20, 20);
    made_message(&t, answer, r, 1, 10, 70, 70, 80, 80);
    return t;
}

static void handler_busy(void **state)
{
    (void)state;
    int32_t handler;
    struct trace t = asking(&handler);
    struct found f = find(&t);
    is_path(&f.path, (struct expected[]){{5, WHY_CALLS, 1},
                                         {15, WHY_NETWORK, TRACE_NONE}, /* the request made the handler due */
                                         {10, WHY_COMPUTING, 0},        /* and was held up */
                                         {10, WHY_HANDLERS, 0},         /* into it */
                                         {20, WHY_HANDLERS, 0},
                                         {10, WHY_HANDLERS, 0},
                                         {10, WHY_NETWORK, TRACE_NONE},
                                         {20, WHY_CALLS, 1},
                                         {0}});
    assert_int_equal(f.path.steps[3].handler, handler);
    assert_true(f.path.steps[3].enters_handler);
    assert_false(f.path.steps[4].enters_handler);
    waited(&f, 1, WAIT_HANDLER, 0, 40);
    waited(&f, 1, WAIT_LATE_SENDER, 0, 25);
    waited(&f, 1, WAIT_NETWORK, 0, 10);
    drop(&t, &f);
}

/* A message that lies at its receiver until the program posts hrecv is not on its way meanwhile: the path
 * goes on with the program. */
static void handler_posted_late(void **state)
{
    (void)state;
    int32_t handler;
    struct trace t = asking(&handler);
    t.messages[t.handlers[handler].message].left = t.messages[t.handlers[handler].message].complete = 12;
    struct found f = find(&t);
    is_path(&f.path, (struct expected[]){{20, WHY_COMPUTING, 0},
                                         {10, WHY_COMPUTING, 0}, /* since the receive was posted */
                                         {10, WHY_HANDLERS, 0},
                                         {20, WHY_HANDLERS, 0},
                                         {10, WHY_HANDLERS, 0},
                                         {10, WHY_NETWORK, TRACE_NONE},
                                         {20, WHY_CALLS, 1},
                                         {0}});
    drop(&t, &f);
}

/* A handler that delays the program leads to the program, not to its message. */
static void handler_in_the_way(void **state)
{
    (void)state;
    int32_t handler;
    struct trace t = asking(&handler);
    t.end = t.to = t.nodes[0].end = 120;
    t.nodes[1].end = 100;
    struct found f = find(&t);
    is_path(&f.path, (struct expected[]){{30, WHY_COMPUTING, 0},
                                         {10, WHY_HANDLERS, 0},
                                         {20, WHY_HANDLERS, 0},
                                         {10, WHY_HANDLERS, 0},
                                         {5, WHY_HANDLERS, 0},
                                         {45, WHY_COMPUTING, 0},
                                         {0}});
    drop(&t, &f);
}

/* While node 1 waits, the sender's processor receives other messages, and its own does, too. */
static void processors_are_busy_with_other_messages(void **state)
{
    (void)state;
    struct trace t = made_trace(2, 100);
    t.nodes[0].end = 70;
    int32_t s = send(&t, 0, 60, 70), r = receive(&t, 1, 0, 100);
    made_idle(&t, made_wait(&t, 0, 95), 75);
    made_system(&t, 0, TRACE_RECEIVING, 20, 50);
    made_system(&t, 1, TRACE_EMPTYING, 40, 55);
    made_system(&t, 1, TRACE_RECEIVING, 90, 95);
    made_message(&t, s, r, 1, 10, 70, 70, 80, 95);
    struct found f = find(&t);
    is_path(&f.path, (struct expected[]){{20, WHY_COMPUTING, 0},
                                         {30, WHY_OTHER_MESSAGES, 0},
                                         {10, WHY_COMPUTING, 0},
                                         {10, WHY_CALLS, 0},
                                         {10, WHY_NETWORK, TRACE_NONE},
                                         {10, WHY_OTHER_MESSAGES, 1},
                                         {5, WHY_MESSAGE, 1},
                                         {5, WHY_CALLS, 1},
                                         {0}});
    assert_int_equal(f.causes.idle, 95 - 15 - 5);
    waited(&f, 1, WAIT_OTHER_MESSAGES, 0, 30 - 10 + 10);
    waited(&f, 1, WAIT_LATE_SENDER, 0, 40 - 5);
    waited(&f, 1, WAIT_NETWORK, 0, 10);
    drop(&t, &f);
}

/* The node's books may say that a wait had less rest than its pieces have, or more: the end of it, or the
 * beginning, belongs to work of the system that the pieces have elsewhere. */
static void rest_by_the_books(void **state)
{
    (void)state;
    for (int more = 0; more < 2; more++) {
        struct trace t = made_trace(2, 100);
        t.nodes[0].end = 70;
        int32_t s = send(&t, 0, 40, 50), r = receive(&t, 1, 0, 100);
        made_idle(&t, made_wait(&t, 0, 100), more ? 100 : 60);
        made_system(&t, 1, TRACE_EMPTYING, 20, 30);
        made_message(&t, s, r, 1, 10, 50, 50, 100, 100);
        struct found f = find(&t);
        assert_int_equal(f.causes.idle, more ? 100 : 60);
        waited(&f, 1, WAIT_LATE_SENDER, 0, more ? 50 : 40);
        waited(&f, 1, WAIT_NETWORK, 0, more ? 50 : 20);
        drop(&t, &f);
    }
}

static void disk(void **state)
{
    (void)state;
    struct trace t = made_trace(1, 100);
    made_call(&t, 0, "cread", TRACE_FILES, 3, 10, 80);
    made_wait(&t, 15, 70);
    struct found f = find(&t);
    is_path(&f.path, (struct expected[]){{10, WHY_COMPUTING, 0},
                                         {5, WHY_CALLS, 0},
                                         {55, WHY_FILES, 0},
                                         {10, WHY_CALLS, 0},
                                         {20, WHY_COMPUTING, 0},
                                         {0}});
    waited(&f, 0, WAIT_DISK, TRACE_NONE, 55);
    drop(&t, &f);
}

/* A wait that lasts to the end of the run. */
static void nothing_comes(void **state)
{
    (void)state;
    struct trace t = made_trace(2, 100);
    t.nodes[0].end = 40;
    int32_t r = receive(&t, 1, 30, 100);
    made_wait(&t, 30, 100);
    t.calls[r].unfinished = true;
    struct found f = find(&t);
    is_path(&f.path, (struct expected[]){{30, WHY_COMPUTING, 1}, {70, WHY_WAITING, 1}, {0}});
    waited(&f, 1, WAIT_NEVER, TRACE_NONE, 70);
    drop(&t, &f);
}

/* Node 0's message to all goes to node 2, whose system forwards it to node 3: the path leads to node 0. */
static void forwarded(void **state)
{
    (void)state;
    struct trace t = made_trace(4, 100);
    t.nodes[0].end = t.nodes[1].end = t.nodes[2].end = 50;
    int32_t s = send(&t, 0, 0, 10), r = receive(&t, 3, 0, 90);
    made_wait(&t, 0, 90);
    made_system(&t, 2, TRACE_SENDING, 30, 45);
    made_message(&t, s, TRACE_NONE, 2, 10, 10, 10, 25, 50);
    int32_t m = made_message(&t, s, r, 3, 10, 45, 45, 90, 90);
    t.messages[m].from = 2;
    struct found f = find(&t);
    is_path(&f.path, (struct expected[]){{10, WHY_CALLS, 0},
                                         {15, WHY_NETWORK, TRACE_NONE},
                                         {5, WHY_OTHER_MESSAGES, 2},
                                         {15, WHY_MESSAGE, 2},
                                         {45, WHY_NETWORK, TRACE_NONE},
                                         {10, WHY_COMPUTING, 3},
                                         {0}});
    drop(&t, &f);
}

/* A machine on which messages take no time: the path ends all the same. */
static void no_time(void **state)
{
    (void)state;
    struct trace t = made_trace(2, 100);
    int32_t s0 = send(&t, 0, 50, 50), r0 = receive(&t, 0, 50, 50);
    made_call(&t, 0, "crecv", TRACE_RECEIVES, 1, 60, 80);
    made_wait(&t, 60, 80);
    int32_t r1 = receive(&t, 1, 10, 50);
    made_wait(&t, 10, 50);
    int32_t s1 = send(&t, 1, 50, 50);
    made_call(&t, 1, "crecv", TRACE_RECEIVES, 1, 70, 80);
    made_wait(&t, 70, 80);
    made_message(&t, s0, r1, 1, 0, 50, 50, 50, 50);
    made_message(&t, s1, r0, 0, 0, 50, 50, 50, 50);
    made_message(&t, s0, TRACE_NONE, 1, 0, 80, 80, 80, 80); /* each seems to end the other's wait */
    made_message(&t, s1, TRACE_NONE, 0, 0, 80, 80, 80, 80);
    struct found f = find(&t);
    assert_int_equal(f.path.steps[0].begin, 0);
    assert_int_equal(f.path.steps[f.path.count - 1].end, 100);
    drop(&t, &f);
}

/* --- random programs, and all paths through them --- */

enum { NODES = 4, MESSAGES = 10, EVENTS = 6 * MESSAGES + 2 * NODES, OPS = 4 * MESSAGES };

/* What happens, and what must have happened so long before: edges[2 of them at most]. */
struct event {
    vtime at;
    int edges;
    struct edge {
        int from;
        vtime takes;
        int computes; /* this node computes meanwhile; -1: none does */
    } edge[2];
};

/* A call of a program: what made_call() and made_wait() need, and the message. */
struct op {
    int32_t node, message;
    bool sends;
    vtime begin, wait_from, wait_to, end;
};

struct sent {
    int from, to, send_op, receive_op;
    bool is_long;
    vtime sent, asked, granted, entered, moved, left, complete;
};

struct program {
    struct event events[EVENTS];
    int event_count;
    int now[NODES]; /* the last event of each node */
    struct op ops[OPS];
    int op_count;
    struct sent messages[MESSAGES];
    int waiting[MESSAGES], waiting_count; /* short messages that nobody has received yet */
};

static vtime random_time(void)
{
    return 1 + (vtime)rand() % 1000000;
}

static int happens(struct program *p, int from, vtime takes, int computes, int too, vtime too_takes)
{
    struct event *e = &p->events[p->event_count];
    *e = (struct event){p->events[from].at + takes, 1, {{from, takes, computes}}};
    if (too >= 0) {
        e->edge[e->edges++] = (struct edge){too, too_takes, -1};
        e->at = vt_max(e->at, p->events[too].at + too_takes);
    }
    return p->event_count++;
}

static void computes(struct program *p, int node)
{
    p->now[node] = happens(p, p->now[node], random_time(), node, -1, 0);
}

static vtime time_at(const struct program *p, int event)
{
    return p->events[event].at;
}

static int adds(struct program *p, int node, int message, bool sends, vtime begin, vtime wait_from, vtime end)
{
    p->ops[p->op_count] = (struct op){node, message, sends, begin, wait_from, end, end};
    return p->op_count++;
}

/* A short message: its sender goes on at once. */
static void sends_short(struct program *p, int m)
{
    struct sent *s = &p->messages[m];
    vtime begin = time_at(p, p->now[s->from]);
    p->now[s->from] = happens(p, p->now[s->from], random_time(), -1, -1, 0);
    s->sent = s->entered = s->moved = time_at(p, p->now[s->from]);
    s->left = s->complete = s->sent + random_time();
    s->granted = (vtime)p->now[s->from]; /* the event: receives_short() wants it */
    s->send_op = adds(p, s->from, m, true, begin, s->sent, s->sent);
    p->waiting[p->waiting_count++] = m;
}

static void receives_short(struct program *p, int at)
{
    int m = p->waiting[at];
    struct sent *s = &p->messages[m];
    p->waiting[at] = p->waiting[--p->waiting_count];
    computes(p, s->to);
    vtime begin = time_at(p, p->now[s->to]);
    p->now[s->to] = happens(p, p->now[s->to], 0, -1, (int)s->granted, s->complete - s->sent);
    s->receive_op = adds(p, s->to, m, false, begin, begin, time_at(p, p->now[s->to]));
}

/* A long message: both wait until it is there. */
static void passes_long(struct program *p, int m)
{
    struct sent *s = &p->messages[m];
    vtime begin = time_at(p, p->now[s->from]), posted = time_at(p, p->now[s->to]), trip = random_time();
    int ready = happens(p, p->now[s->from], random_time(), -1, -1, 0);
    int granted = happens(p, ready, trip, -1, p->now[s->to], 0);
    vtime back = random_time(), blocked = random_time(), moves = random_time();
    s->is_long = true;
    s->sent = time_at(p, ready), s->asked = s->sent + trip, s->granted = time_at(p, granted);
    s->entered = s->granted + back, s->moved = s->entered + blocked, s->left = s->complete = s->moved + moves;
    p->now[s->from] = p->now[s->to] = happens(p, granted, back + blocked + moves, -1, -1, 0);
    s->send_op = adds(p, s->from, m, true, begin, s->sent, s->left);
    s->receive_op = adds(p, s->to, m, false, posted, posted, s->complete);
}

static struct program random_program(void)
{
    struct program p = {.event_count = 1};
    for (int m = 0; m < MESSAGES; m++) {
        struct sent *s = &p.messages[m];
        s->from = rand() % NODES, s->to = (s->from + 1 + rand() % (NODES - 1)) % NODES;
        computes(&p, s->from);
        if (rand() % 2) {
            computes(&p, s->to);
            passes_long(&p, m);
        } else {
            sends_short(&p, m);
        }
        while (p.waiting_count && rand() % 2)
            receives_short(&p, rand() % p.waiting_count);
    }
    while (p.waiting_count)
        receives_short(&p, 0);
    for (int i = 0; i < NODES; i++)
        computes(&p, i);
    return p;
}

/* The program's run as a trace. */
static struct trace trace_of(const struct program *p)
{
    struct trace t = made_trace(NODES, 0);
    int32_t call[OPS];
    for (int32_t node = 0; node < NODES; node++) {
        t.nodes[node].end = time_at(p, p->now[node]);
        t.end = t.to = vt_max(t.end, t.nodes[node].end);
        for (int i = 0; i < p->op_count; i++) {
            const struct op *o = &p->ops[i];
            if (o->node != node)
                continue;
            call[i] = o->sends ? send(&t, node, o->begin, o->end) : receive(&t, node, o->begin, o->end);
            if (o->wait_to > o->wait_from)
                made_wait(&t, o->wait_from, o->wait_to);
        }
    }
    for (int m = 0; m < MESSAGES; m++) {
        const struct sent *s = &p->messages[m];
        made_message(&t, call[s->send_op], call[s->receive_op], s->to, 1, s->sent, s->moved, s->left,
                     s->complete);
        if (s->is_long)
            made_long(&t, s->asked, s->granted, s->entered);
        if (s->is_long)
            made_block(&t, 1, s->entered, s->moved);
    }
    return t;
}

/* A path through the events, and how long each node computes on it. */
struct longest {
    vtime length, computing[NODES];
    int count; /* of paths of that length */
};

/* Tries all paths that end at an event: the plain way. */
static void try_all(const struct program *p, int event, struct longest so_far, struct longest *best)
{
    const struct event *e = &p->events[event];
    if (event == 0) {
        if (so_far.length < best->length)
            return;
        int count = so_far.length == best->length ? best->count + 1 : 1;
        *best = so_far;
        best->count = count;
        return;
    }
    for (int i = 0; i < e->edges; i++) {
        struct longest next = so_far;
        next.length += e->edge[i].takes;
        if (e->edge[i].computes >= 0)
            next.computing[e->edge[i].computes] += e->edge[i].takes;
        try_all(p, e->edge[i].from, next, best);
    }
}

static vtime idle_of(const struct trace *t)
{
    vtime idle = 0;
    for (int32_t i = 0; i < t->wait_count; i++)
        idle += t->waits[i].idle;
    return idle;
}

/* The path found is the longest of all; and the causes' sum is the waits'. */
static void longest_path(void **state)
{
    (void)state;
    int unique = 0;
    srand(22);
    for (int round = 0; round < 300; round++) {
        struct program p = random_program();
        struct longest best = {0};
        for (int i = 0; i < NODES; i++)
            try_all(&p, p.now[i], (struct longest){0}, &best);
        struct trace t = trace_of(&p);
        struct found f = find(&t);
        vtime computing[NODES] = {0};
        for (size_t i = 0; i < f.path.count; i++)
            if (f.path.steps[i].class == WHY_COMPUTING)
                computing[f.path.steps[i].node] += f.path.steps[i].end - f.path.steps[i].begin;
        assert_int_equal(best.length, t.end);
        if (best.count == 1) {
            unique++;
            for (int i = 0; i < NODES; i++)
                assert_int_equal(computing[i], best.computing[i]);
        }
        assert_int_equal(f.causes.idle, idle_of(&t));
        assert_int_equal(f.causes.by_cause[WAIT_UNKNOWN], 0);
        drop(&t, &f);
    }
    assert_true(unique > 250);
}

/* --- random traces, without sense: the promises hold all the same --- */

/* Times of a message in their order; sometimes it never comes so far. */
static void scramble(struct trace *t, vtime end)
{
    struct trace_message *m = &t->messages[t->message_count - 1];
    vtime *times[] = {&m->sent, &m->asked, &m->granted, &m->entered, &m->moved, &m->left, &m->complete};
    vtime at = (vtime)rand() % end;
    m->is_long = rand() % 2;
    for (int i = 0; i < 7; i++) {
        bool skipped = !m->is_long && (i == 1 || i == 2);
        at += (vtime)rand() % 3 ? (vtime)rand() % 8 : 0;
        *times[i] = skipped || at > end ? VT_NEVER : at;
    }
    if (rand() % 8 == 0)
        m->sending = TRACE_NONE;
    if (rand() % 16 == 0)
        m->from = TRACE_NONE;
    if (m->moved != VT_NEVER && m->moved > m->entered && rand() % 2)
        made_block(t, 1, m->entered, m->entered + (vtime)rand() % (m->moved - m->entered + 1));
}

static void random_node(struct trace *t, int32_t node, vtime end)
{
    vtime at = t->from, length;
    for (; at < end; at += length) {
        length = vt_min(1 + (vtime)rand() % 12, end - at);
        int kind = rand() % 8;
        if (kind < 4) {
            made_call(t, node, kind ? "crecv" : "cread", kind ? TRACE_RECEIVES : TRACE_FILES, 1, at,
                      at + length);
            if (rand() % 3)
                made_wait(t, at + (vtime)rand() % length, at + length);
        } else if (kind == 4) {
            int32_t h = made_handler(t, node, at > 5 ? at - (vtime)rand() % 5 : at, at, at + length);
            t->handlers[h].message = rand() % 40;
            if (rand() % 2) {
                int32_t c = send(t, node, at, at + length);
                t->calls[c].in_handler = true;
            }
        } else if (kind == 5) {
            made_system(t, node, (enum trace_task)(rand() % 4), at, at + length);
        }
    }
}

static void any_trace(void **state)
{
    (void)state;
    const vtime END = 400;
    srand(4);
    for (int round = 0; round < 400; round++) {
        struct trace t = made_trace(3, END);
        t.from = round % 3 ? 0 : 100;
        for (int32_t node = 0; node < 3; node++) {
            t.nodes[node].end = END - (vtime)rand() % 20;
            random_node(&t, node, t.nodes[node].end);
        }
        for (int m = 0; m < 40; m++) {
            made_message(&t, rand() % t.call_count, rand() % 2 ? TRACE_NONE : rand() % t.call_count,
                         rand() % 3, 1, 0, 0, 0, 0);
            scramble(&t, END);
        }
        if (round % 4 == 0)
            t.nodes[1].traced = false;
        struct found f = find(&t); /* asserts what critical_path.h and wait_causes.h promise */
        assert_true(f.path.count > 0);
        drop(&t, &f);
    }
}

/* A page and a script look a class and a cause up by their keys: one thing has one name and one key. */
static void a_class_and_a_cause_of_one_name_have_one_key(void **state)
{
    (void)state;
    for (int c = 0; c < WHY_CLASSES; c++)
        for (int w = 0; w < WAIT_CAUSES; w++)
            assert_int_equal(strcmp(why_class_name(c), wait_cause_name(w)) == 0,
                             strcmp(why_class_key(c), wait_cause_key(w)) == 0);
    assert_string_equal(why_class_key(WHY_OTHER_MESSAGES), "other_messages");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(late_sender),
        cmocka_unit_test(late_receiver),
        cmocka_unit_test(early_receiver),
        cmocka_unit_test(channel_busy),
        cmocka_unit_test(handler_busy),
        cmocka_unit_test(handler_posted_late),
        cmocka_unit_test(handler_in_the_way),
        cmocka_unit_test(processors_are_busy_with_other_messages),
        cmocka_unit_test(a_class_and_a_cause_of_one_name_have_one_key),
        cmocka_unit_test(rest_by_the_books),
        cmocka_unit_test(disk),
        cmocka_unit_test(nothing_comes),
        cmocka_unit_test(forwarded),
        cmocka_unit_test(no_time),
        cmocka_unit_test(longest_path),
        cmocka_unit_test(any_trace),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
