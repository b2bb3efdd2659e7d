/* node_record.c - see node_record.h. */
#include "record/node_record.h"
#include <assert.h>
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lp/clock.h"
#include "net/protocol_record.h"
#include "node/self.h"
#include "node/system.h"
#include "os/due.h"
#include "os/observer.h"
#include "os/order.h"
#include "trace/recorder.h"

enum { DEEPEST_STACK = 32 };

/* What a call's program is told when its caller resumes. */
struct told {
    uint8_t flags; /* of CALL_HAS_TYPE and CALL_TOOK */
    uint32_t taken_source, wait_count;
    int64_t type;
    uint64_t taken_order;
    vtime taken_at;
};

/* What has begun and not ended: a call, or a handler. */
struct open {
    union {
        struct recorded_call call;
        struct recorded_handler handler; /* if is_handler */
    };
    bool is_handler;
    bool sends; /* what the call waits for: hear_awaits */
    /* Of a deferred call: its time of beginning is known; its program has left it, after such a time,
     * whatever puts off both. */
    bool begun, left;
    uint32_t wait_room; /* of `waits` */
    long from;
    vtime takes;
    struct recorded_wait wait;   /* if the call has had one only */
    struct recorded_wait *waits; /* if it has had several */
    struct told sure;            /* what was known of it when it was deferred */
};

enum { DEEPEST = 4, NEAR = 4 };

/* Most programs have few deferred calls at a time; what they need lies close together. */
struct node_record {
    struct observer observer; /* first */
    uint32_t program;
    const struct nxm_told *library; /* the call of MPI that the program is in; NULL: none */
    bool continues;                 /* a call of the system was made in it */
    int depth;
    struct open open[DEEPEST];
    struct open deferred[NEAR]; /* as node.calls, whose others are in `others`. NULL: none yet */
    struct open *others;
};

static struct node_record *record_of(struct observer *o)
{
    return (struct node_record *)o;
}

static struct recorder *recorder_of(const struct node *n)
{
    return n->sys->recorder;
}

static struct open *top(struct node_record *r)
{
    return r->depth ? &r->open[r->depth - 1] : NULL;
}

/* The i-th deferred call. */
static struct open *nth_deferred(struct node_record *r, const struct node *n, uint32_t i)
{
    uint32_t at = (n->deferred.first + i) % DEFERRED_MOST;
    if (at < NEAR)
        return &r->deferred[at];
    if (!r->others)
        r->others = xcalloc(DEFERRED_MOST - NEAR, sizeof *r->others);
    return &r->others[at - NEAR];
}

/* What the program is in. */
static struct open *innermost(struct node_record *r, const struct node *n)
{
    return n->deferred.open ? nth_deferred(r, n, n->deferred.count - 1) : top(r);
}

static struct open *innermost_call(struct node_record *r, const struct node *n)
{
    struct open *o = innermost(r, n);
    return o && !o->is_handler ? o : NULL;
}

static struct open *push(struct node_record *r, bool is_handler)
{
    assert(r->depth < DEEPEST);
    struct open *o = &r->open[r->depth++];
    o->is_handler = is_handler;
    return o;
}

static void hear_no_program(struct observer *by, struct node *n, vtime t)
{
    (void)by;
    recorder_no_program(recorder_of(n), n->lp.address, t);
}

/* --- where the program is --- */

/* The program's stack: its number +1, or 0. The frames of the simulator come first and are left out; the
 * stack ends with the gate by which it has called main, or the handler. */
static uint32_t stack_now(const struct node_record *r, struct node *n, const void *innermost)
{
    uintptr_t offsets[DEEPEST_STACK];
    uint32_t depth = 0;
    for (uintptr_t frame = (uintptr_t)innermost; node_may_be_frame(n, frame) && depth < DEEPEST_STACK;) {
        uintptr_t next = ((const uintptr_t *)frame)[0],
                  offset = ((const uintptr_t *)frame)[1] - (uintptr_t)n->guest.program;
        if (offset < n->guest.image_bytes)
            offsets[depth++] = offset;
        else if (depth)
            break;
        if (next <= frame)
            break;
        frame = next;
    }
    return depth ? recorder_stack(recorder_of(n), r->program, offsets, depth) + 1 : 0;
}

/* --- calls --- */

/* Is the call that begins a part of the call of MPI that the one before was a part of? */
static bool continues(struct node_record *r, const struct node *n)
{
    bool yes = r->library && !n->in_handler && r->continues;
    r->continues = r->library && !n->in_handler;
    return yes;
}

static void begin_call(struct node_record *r, struct node *n, struct open *o, const void *innermost_frame)
{
    o->call = (struct recorded_call){
        .address = n->lp.address,
        .name = recorder_name(recorder_of(n), n->call.name),
        .stack = stack_now(r, n, innermost_frame),
        .flags = (uint8_t)((n->in_handler ? CALL_IN_HANDLER : 0) | (continues(r, n) ? CALL_CONTINUES : 0)),
        .begin = node_now(n)};
    o->is_handler = o->sends = o->begun = o->left = false, o->from = -1;
}

static void hear_call_begins(struct observer *by, struct node *n)
{
    struct node_record *r = record_of(by);
    begin_call(r, n, push(r, false), __builtin_frame_address(0));
}

static void end_call(struct node *n, struct open *o, vtime t)
{
    o->call.end = t;
    o->call.ordered = vt_min(vt_max(o->call.ordered, o->call.begin), t);
    o->call.waits = o->call.wait_count > 1 ? o->waits : &o->wait;
    recorder_call(recorder_of(n), &o->call);
}

static void hear_call_ends(struct observer *by, struct node *n)
{
    struct node_record *r = record_of(by);
    struct open *o = innermost(r, n);
    if (!o)
        return; /* the program begins */
    if (o->is_handler) {
        o->handler.entered = node_now(n);
        o->handler.type = n->info.type;
        return;
    }
    if (n->call.has_type)
        o->call.flags |= CALL_HAS_TYPE, o->call.type = n->call.type;
    if (n->deferred.open) {
        o->takes = node_now(n) - o->call.begin;
        o->left = true;
    } else {
        o->call.ordered = n->sys->schedule.reached.time;
        end_call(n, o, node_now(n));
        r->depth--;
    }
}

static void hear_awaits(struct observer *by, struct node *n, bool sends, long from)
{
    struct node_record *r = record_of(by);
    struct open *o = innermost_call(r, n);
    if (o)
        o->sends = sends, o->from = from;
}

static struct recorded_wait *next_wait(struct open *o)
{
    uint32_t count = o->call.wait_count++;
    if (!count)
        return &o->wait;
    if (count >= o->wait_room) {
        o->wait_room = o->wait_room ? 2 * o->wait_room : 4;
        o->waits = xreallocarray(o->waits, o->wait_room, sizeof *o->waits);
    }
    if (count == 1)
        o->waits[0] = o->wait;
    return &o->waits[count];
}

static void hear_waited(struct observer *by, struct node *n, vtime begin, vtime end, vtime busy)
{
    struct node_record *r = record_of(by);
    struct open *o = innermost_call(r, n);
    if (!o || end == begin)
        return;
    struct recorded_wait *w = next_wait(o);
    *w = (struct recorded_wait){.begin = begin, .end = end, .busy = busy};
    if (n->call.awaits)
        w->flags |= WAIT_HAS_TYPE, w->type = n->call.awaited;
    if (o->sends)
        w->flags |= WAIT_SENDS;
    else if (o->from >= 0)
        w->flags |= WAIT_HAS_FROM, w->from = (uint32_t)o->from;
}

static void hear_sends(struct observer *by, struct node *n, const struct observed_send *what)
{
    struct node_record *r = record_of(by);
    struct open *o = innermost_call(r, n);
    if (!o)
        return;
    if (!(o->call.flags & CALL_SENT))
        o->call.sent_order = what->order;
    o->call.flags |= CALL_SENT;
    o->call.sent_count = what->order + what->count - o->call.sent_order;
}

static void hear_takes(struct observer *by, struct node *n, struct receive *taken)
{
    const struct message *m = taken->m;
    struct node_record *r = record_of(by);
    struct open *o = innermost(r, n);
    if (o && o->is_handler) {
        o->handler.flags |= HANDLER_HAS_MESSAGE;
        o->handler.source = m->source, o->handler.order = protocol_recorded_order(m);
    } else if (o) {
        o->call.flags |= CALL_TOOK;
        o->call.taken_source = m->source, o->call.taken_order = protocol_recorded_order(m);
        o->call.taken_at = node_now(n);
    }
}

/* --- deferred calls --- */

/* Exchanges two, each of which keeps its room for waits. */
static void exchange(struct open *a, struct open *b)
{
    struct open before = *a;
    *a = *b, *b = before;
}

static const uint8_t TOLD = CALL_HAS_TYPE | CALL_TOOK;

static struct told told_of(const struct recorded_call *c)
{
    return (struct told){.flags = c->flags & TOLD,
                         .taken_source = c->taken_source,
                         .wait_count = c->wait_count,
                         .type = c->type,
                         .taken_order = c->taken_order,
                         .taken_at = c->taken_at};
}

static void hear_deferred(struct observer *by, struct node *n)
{
    struct node_record *r = record_of(by);
    struct open *o = nth_deferred(r, n, n->deferred.count - 1);
    begin_call(r, n, o, __builtin_frame_address(0));
    o->sure = told_of(&o->call);
}

static void hear_deferred_again(struct observer *by, struct node *n)
{
    struct node_record *r = record_of(by);
    struct open *o = nth_deferred(r, n, n->deferred.count - 1);
    exchange(o, top(r));
    r->depth--;
    o->begun = true;
    o->sure = told_of(&o->call);
}

static void hear_committed(struct observer *by, struct node *n, vtime t)
{
    struct node_record *r = record_of(by);
    struct open *o = nth_deferred(r, n, 0);
    o->call.end = t + o->takes;
    o->call.begin = t;
    o->begun = true;
}

static void hear_resumed(struct observer *by, struct node *n, vtime t, vtime takes_last, vtime done)
{
    struct node_record *r = record_of(by);
    struct open *o = nth_deferred(r, n, 0);
    o->call.ordered = t, o->call.taken_at = takes_last, o->call.end = done;
}

static void hear_popped(struct observer *by, struct node *n)
{
    struct node_record *r = record_of(by);
    struct open *o = nth_deferred(r, n, 0);
    if (o->left)
        end_call(n, o, o->call.end);
    else
        exchange(push(r, false), o);
}

/* The caller resumed, which it now does not; what the call has sent, it sent when it began. */
static void forget_resuming(struct recorded_call *c, const struct told *sure)
{
    c->flags = (uint8_t)((c->flags & ~TOLD) | sure->flags);
    c->taken_source = sure->taken_source, c->wait_count = sure->wait_count;
    c->type = sure->type;
    c->taken_order = sure->taken_order, c->taken_at = sure->taken_at;
}

/* The program goes no further. If it was in the first of them, it still is. */
static void hear_rolled_back(struct observer *by, struct node *n)
{
    struct node_record *r = record_of(by);
    struct open *o = nth_deferred(r, n, 0);
    if (!n->deferred.count || !o->begun)
        return;
    forget_resuming(&o->call, &o->sure);
    exchange(push(r, false), o);
}

/* --- handlers --- */

static void hear_handler_begins(struct observer *by, struct node *n, const struct due *d)
{
    struct node_record *r = record_of(by);
    uint32_t stack = stack_now(r, n, __builtin_frame_address(0));
    struct open *o = push(r, true);
    o->handler = (struct recorded_handler){
        .address = n->lp.address, .stack = stack, .due = d->at, .begin = node_now(n), .entered = VT_NEVER};
}

static void hear_handler_ends(struct observer *by, struct node *n)
{
    struct node_record *r = record_of(by);
    vtime left = top(r)->call.begin; /* of the call by which the system ends a handler */
    r->depth--;
    struct open *o = top(r);
    assert(o->is_handler);
    o->handler.left = left;
    o->handler.end = node_now(n);
    recorder_handler(recorder_of(n), &o->handler);
    r->depth--;
}

/* --- the system --- */

static void hear_system(struct observer *by, struct node *n, enum node_task task, vtime end, vtime t)
{
    (void)by;
    vtime now = n->sys->schedule.reached.time;
    recorder_system(recorder_of(n), n->lp.address, task, vt_min(now, end - t), end - t, end);
}

/* --- the end --- */

static void end_open(struct node *n, struct open *o, vtime t, bool unfinished)
{
    if (o->is_handler) {
        o->handler.end = vt_max(t, o->handler.begin);
        o->handler.entered = vt_min(o->handler.entered, o->handler.end);
        o->handler.left = o->handler.end;
        o->handler.flags |= unfinished ? HANDLER_UNFINISHED : 0;
        recorder_handler(recorder_of(n), &o->handler);
    } else {
        o->call.flags |= unfinished ? CALL_UNFINISHED : 0;
        o->call.ordered = t;
        end_call(n, o, vt_max(t, o->call.begin));
    }
}

static void hear_ends(struct observer *by, struct node *n, vtime t)
{
    struct node_record *r = record_of(by);
    bool unfinished = n->end.how != NODE_RETURNED && n->end.how != NODE_EXITED;
    for (; r->depth; r->depth--)
        end_open(n, top(r), t, unfinished);
    recorder_node_end(recorder_of(n), n->lp.address, t);
    for (int i = 0; i < DEEPEST; i++)
        free(r->open[i].waits);
    for (int i = 0; i < NEAR; i++)
        free(r->deferred[i].waits);
    for (int i = 0; r->others && i < DEFERRED_MOST - NEAR; i++)
        free(r->others[i].waits);
    free(r->others);
    observer_remove(n, by);
    free(r);
}

/* --- the beginning --- */

/* (Told on any thread: of the program's order alone.) */
static void hear_library_begins(struct observer *by, struct node *n, const struct nxm_told *c,
                                const struct nxm_library *l)
{
    struct node_record *r = record_of(by);
    (void)n, (void)l;
    if (r->library && c < r->library) /* by a function that MPI's library has called */
        return;
    r->library = c;
    r->continues = false;
}

static void hear_library_ends(struct observer *by, struct node *n, const struct nxm_told *c,
                              const struct nxm_library *l)
{
    struct node_record *r = record_of(by);
    (void)n, (void)l;
    if (r->library == c)
        r->library = NULL;
}

static const struct announcements heard = {
    .library_begins = hear_library_begins,
    .library_ends = hear_library_ends,
    .no_program = hear_no_program,
    .ends = hear_ends,
    .call_begins = hear_call_begins,
    .call_ends = hear_call_ends,
    .awaits = hear_awaits,
    .waited = hear_waited,
    .sends = hear_sends,
    .takes = hear_takes,
    .deferred = hear_deferred,
    .deferred_again = hear_deferred_again,
    .committed = hear_committed,
    .resumed = hear_resumed,
    .popped = hear_popped,
    .rolled_back = hear_rolled_back,
    .handler_begins = hear_handler_begins,
    .handler_ends = hear_handler_ends,
    .system = hear_system,
};

void record_begin(struct node *n, uint32_t program)
{
    if (!recorder_wants(recorder_of(n), n->lp.address))
        return;
    struct node_record *r = xcalloc(1, sizeof *r);
    r->observer.hears = &heard;
    r->program = program;
    observer_add(n, &r->observer);
    vtime begins = vt_max(n->sys->schedule.reached.time, n->lp.clock.now);
    if (begins)
        recorder_no_program(recorder_of(n), n->lp.address, begins);
}
