/* node_record.c - see node_record.h. */
#include "node/self.h"
#include "os/node_record.h"
#include <assert.h>
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lp/clock.h"
#include "net/protocol_record.h"
#include "os/order.h"
#include "trace/recorder.h"

enum { DEEPEST_STACK = 32 };

/* What has begun and not ended: a call, or a handler. */
struct open {
    union {
        struct recorded_call call;
        struct recorded_handler handler; /* if is_handler */
    };
    bool is_handler;
    struct recorded_wait *waits;
    uint32_t wait_room;
    bool sends; /* what the call waits for: record_awaits */
    long from;
    /* Of a deferred call: its time of beginning is known; its program has left it, after such a time,
     * whatever puts off both. */
    bool begun, left;
    vtime takes;
};

enum { DEEPEST = 4 };

struct node_record {
    uint32_t program;
    int depth;
    struct open open[DEEPEST];
    struct open deferred[DEFERRED_MOST]; /* as node.calls */
};

static struct recorder *recorder_of(const struct node *n)
{
    return n->sys->recorder;
}

static struct open *top(const struct node *n)
{
    struct node_record *r = n->record;
    return r->depth ? &r->open[r->depth - 1] : NULL;
}

/* The i-th deferred call. */
static struct open *nth_deferred(const struct node *n, uint32_t i)
{
    return &n->record->deferred[(n->deferred.first + i) % DEFERRED_MOST];
}

/* What the program is in. */
static struct open *innermost(const struct node *n)
{
    return n->deferred.open ? nth_deferred(n, n->deferred.count - 1) : top(n);
}

static struct open *innermost_call(const struct node *n)
{
    struct open *o = innermost(n);
    return o && !o->is_handler ? o : NULL;
}

static struct open *push(struct node *n, bool is_handler)
{
    struct node_record *r = n->record;
    assert(r->depth < DEEPEST);
    struct open *o = &r->open[r->depth++];
    o->is_handler = is_handler;
    return o;
}

void record_begin(struct node *n, uint32_t program)
{
    if (!recorder_wants(recorder_of(n), n->lp.address))
        return;
    n->record = xcalloc(1, sizeof *n->record);
    n->record->program = program;
    vtime begins = vt_max(schedule_reached(&n->sys->schedule).time, n->lp.clock.now);
    if (begins)
        record_no_program(n, begins);
}

void record_no_program(struct node *n, vtime t)
{
    recorder_no_program(recorder_of(n), n->lp.address, t);
}

/* --- where the program is --- */

/* The program's stack: its number +1, or 0. The frames of the simulator come first and are left out; the
 * stack ends with the gate by which it has called main, or the handler. */
static uint32_t stack_now(struct node *n, const void *innermost)
{
    uintptr_t offsets[DEEPEST_STACK];
    uint32_t depth = 0;
    for (uintptr_t frame = (uintptr_t)innermost; node_may_be_frame(n, frame) && depth < DEEPEST_STACK;) {
        uintptr_t next = ((const uintptr_t *)frame)[0],
                  offset = ((const uintptr_t *)frame)[1] - (uintptr_t)n->program;
        if (offset < n->image_bytes)
            offsets[depth++] = offset;
        else if (depth)
            break;
        if (next <= frame)
            break;
        frame = next;
    }
    return depth ? recorder_stack(recorder_of(n), n->record->program, offsets, depth) + 1 : 0;
}

/* --- calls --- */

static void begin_call(struct node *n, struct open *o, const void *innermost_frame)
{
    o->call = (struct recorded_call){.address = n->lp.address,
                                     .name = recorder_name(recorder_of(n), n->call),
                                     .stack = stack_now(n, innermost_frame),
                                     .flags = n->in_handler ? CALL_IN_HANDLER : 0,
                                     .begin = node_now(n)};
    o->is_handler = o->sends = o->begun = o->left = false, o->from = -1;
}

void record_call_begins(struct node *n)
{
    begin_call(n, push(n, false), __builtin_frame_address(0));
}

static void end_call(struct node *n, struct open *o, vtime t)
{
    o->call.end = t;
    o->call.ordered = vt_min(vt_max(o->call.ordered, o->call.begin), t);
    o->call.waits = o->waits;
    recorder_call(recorder_of(n), &o->call);
}

void record_call_ends(struct node *n)
{
    struct open *o = innermost(n);
    if (!o)
        return; /* the program begins */
    if (o->is_handler) {
        o->handler.entered = node_now(n);
        o->handler.type = n->info.type;
        return;
    }
    if (n->call_has_type)
        o->call.flags |= CALL_HAS_TYPE, o->call.type = n->call_type;
    if (n->deferred.open) {
        o->takes = node_now(n) - o->call.begin;
        o->left = true;
    } else {
        o->call.ordered = schedule_reached(&n->sys->schedule).time;
        end_call(n, o, node_now(n));
        n->record->depth--;
    }
}

void record_awaits(struct node *n, bool sends, long from)
{
    struct open *o = innermost_call(n);
    if (o)
        o->sends = sends, o->from = from;
}

void record_waited(struct node *n, vtime begin, vtime end, vtime busy)
{
    struct open *o = innermost_call(n);
    if (!o || end == begin)
        return;
    if (o->call.wait_count == o->wait_room) {
        o->wait_room = o->wait_room ? 2 * o->wait_room : 4;
        o->waits = xreallocarray(o->waits, o->wait_room, sizeof *o->waits);
    }
    struct recorded_wait *w = &o->waits[o->call.wait_count++];
    *w = (struct recorded_wait){.begin = begin, .end = end, .busy = busy};
    if (n->awaits)
        w->flags |= WAIT_HAS_TYPE, w->type = n->awaited;
    if (o->sends)
        w->flags |= WAIT_SENDS;
    else if (o->from >= 0)
        w->flags |= WAIT_HAS_FROM, w->from = (uint32_t)o->from;
}

void record_sends(struct node *n, uint64_t order, uint64_t count)
{
    struct open *o = innermost_call(n);
    if (!o)
        return;
    if (!(o->call.flags & CALL_SENT))
        o->call.sent_order = order;
    o->call.flags |= CALL_SENT;
    o->call.sent_count = order + count - o->call.sent_order;
}

void record_takes(struct node *n, const struct message *m)
{
    struct open *o = innermost(n);
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

void record_deferred(struct node *n)
{
    begin_call(n, nth_deferred(n, n->deferred.count - 1), __builtin_frame_address(0));
}

void record_deferred_again(struct node *n)
{
    struct open *o = nth_deferred(n, n->deferred.count - 1);
    exchange(o, top(n));
    n->record->depth--;
    o->begun = true;
}

void record_committed(struct node *n, vtime t)
{
    struct open *o = nth_deferred(n, 0);
    o->call.end = t + o->takes;
    o->call.begin = t;
    o->begun = true;
}

void record_resumed(struct node *n, vtime t, vtime done)
{
    struct open *o = nth_deferred(n, 0);
    o->call.taken_at = o->call.ordered = t, o->call.end = done;
}

void record_popped(struct node *n)
{
    struct open *o = nth_deferred(n, 0);
    if (o->left)
        end_call(n, o, o->call.end);
    else
        exchange(push(n, false), o);
}

/* The program goes no further. If it was in the first of them, it still is. */
void record_rolled_back(struct node *n)
{
    if (n->deferred.count && nth_deferred(n, 0)->begun)
        exchange(push(n, false), nth_deferred(n, 0));
}

/* --- handlers --- */

void record_handler_begins(struct node *n, vtime due)
{
    uint32_t stack = stack_now(n, __builtin_frame_address(0));
    struct open *o = push(n, true);
    o->handler = (struct recorded_handler){
        .address = n->lp.address, .stack = stack, .due = due, .begin = node_now(n), .entered = VT_NEVER};
}

void record_handler_ends(struct node *n)
{
    vtime left = top(n)->call.begin; /* of the call by which the system ends a handler */
    n->record->depth--;
    struct open *o = top(n);
    assert(o->is_handler);
    o->handler.left = left;
    o->handler.end = node_now(n);
    recorder_handler(recorder_of(n), &o->handler);
    n->record->depth--;
}

/* --- the system --- */

void record_system(struct node *n, enum node_task task, vtime end, vtime t)
{
    vtime now = schedule_reached(&n->sys->schedule).time;
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

void record_end(struct node *n, vtime t)
{
    struct node_record *r = n->record;
    bool unfinished = n->end != NODE_RETURNED && n->end != NODE_EXITED;
    for (; r->depth; r->depth--)
        end_open(n, top(n), t, unfinished);
    recorder_node_end(recorder_of(n), n->lp.address, t);
    for (int i = 0; i < DEEPEST; i++)
        free(r->open[i].waits);
    for (int i = 0; i < DEFERRED_MOST; i++)
        free(r->deferred[i].waits);
    free(r);
    n->record = NULL;
}
