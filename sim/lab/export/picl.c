/* picl.c - a trace in the format of PICL, Oak Ridge's Portable Instrumented Communication Library, which
 * ParaGraph reads: P. H. Worley, "A New PICL Trace File Format", ORNL/TM-12125, 1992. (Not at hand. The
 * layout of records and the numbers here are those that other writers and readers of the format, which cite
 * the report, agree on: the manual of coNCePTuaL, section "The picl backend"; the list of MPICL's keys.)
 *
 * A line is an event, in order of time:
 *
 *     record  event  seconds  processor  process  fields [descriptor field ...]
 *
 * record      -3 an event begins, -4 it ends
 * process     of the processor: the same number
 * descriptor  of the fields: 2, they are whole numbers
 *
 *     event                                 fields, when it begins      when it ends
 *     -901  the processor is traced         none                        none
 *      -21  send                            bytes type to process       none
 *      -51  receive that did not block      type from process           bytes type from process
 *      -52  receive that blocked            type from process           bytes type from process
 *     -601  idle                            none                        none
 *     -602  the system's overhead           none                        none
 *
 * Each picosecond of a node is in at most one event inside of -901: idle is in -52 and -601; the system,
 * whether in a call or for a message, in -21, -51 and -602; computing is in none. These are to be ParaGraph's
 * idle, overhead and busy. (ParaGraph itself was not at hand, either.) */
#include "lab/export/picl.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "lab/export/decimal.h"
#include "lab/export/in_order.h"

enum { BEGIN = -3, END = -4 };
enum { SEND = -21, RECEIVE = -51, RECEIVE_BLOCKED = -52, IDLE = -601, OVERHEAD = -602, TRACED = -901 };

struct writing {
    const struct timeline *l;
    struct in_order *lines;
    int32_t node;
    struct trace_pieces pieces;
    struct timeline_end *ends; /* of the node's messages, in order of time */
    size_t end_count, end_room;
    size_t next; /* the first end that is not written */
};

/* --- lines --- */

static void put(struct writing *w, int record, int event, vtime at)
{
    in_order_line(w->lines, at, "%d %d %" PRI_SECONDS " %d %d 0\n", record, event, SECONDS(at), w->node,
                  w->node);
}

static void put_event(struct writing *w, int event, vtime begin, vtime end)
{
    put(w, BEGIN, event, begin);
    put(w, END, event, end);
}

static void put_send(struct writing *w, const struct trace_message *m, vtime begin, vtime end)
{
    in_order_line(w->lines, begin, "%d %d %" PRI_SECONDS " %d %d 4 2 %" PRIu64 " %d %d %d\n", BEGIN, SEND,
                  SECONDS(begin), w->node, w->node, m->bytes, m->type, m->to, m->to);
    put(w, END, SEND, end);
}

static void put_receive(struct writing *w, int event, int32_t message, vtime begin, vtime end)
{
    const struct trace_message *m = &w->l->trace->messages[message];
    int32_t from = timeline_sender(w->l, message);
    in_order_line(w->lines, begin, "%d %d %" PRI_SECONDS " %d %d 3 2 %d %d %d\n", BEGIN, event,
                  SECONDS(begin), w->node, w->node, m->type, from, from);
    in_order_line(w->lines, end, "%d %d %" PRI_SECONDS " %d %d 4 2 %" PRIu64 " %d %d %d\n", END, event,
                  SECONDS(end), w->node, w->node, m->bytes, m->type, from, from);
}

/* An end of a message, as an event over that time. */
static void put_end(struct writing *w, const struct timeline_end *e, int receive, vtime begin, vtime end)
{
    if (e->taken)
        put_receive(w, receive, e->message, begin, end);
    else
        put_send(w, &w->l->trace->messages[e->message], begin, end);
}

/* --- pieces --- */

/* The node's ends of messages; without those to and from services, which are no processors of the program,
 * and without those that come from where the trace is not: readers expect that what is received was sent. */
static void note_end(void *ctx, const struct timeline_end *e)
{
    struct writing *w = ctx;
    const struct trace_message *m = &w->l->trace->messages[e->message];
    if (timeline_sender(w->l, e->message) == TRACE_NONE || m->to == TRACE_NONE ||
        (e->taken && !timeline_has_ends(w->l, e->message)))
        return;
    if (w->end_count == w->end_room) {
        w->end_room = 2 * w->end_room + 64;
        w->ends = xreallocarray(w->ends, w->end_room, sizeof *w->ends);
    }
    w->ends[w->end_count++] = *e;
}

/* The next end, if that is at `until` or before. */
static const struct timeline_end *next_until(const struct writing *w, vtime until)
{
    return w->next < w->end_count && w->ends[w->next].at <= until ? &w->ends[w->next] : NULL;
}

/* Is the piece the last wait of its call before the end, in which the call took a message? Not if the message
 * was sent later: then the rest of the wait counts as the system's, and nobody receives what is not sent. */
static bool waited_for(const struct writing *w, size_t piece, const struct timeline_end *e)
{
    const struct trace_piece *list = w->pieces.list;
    if (!e->taken || e->call == TRACE_NONE || e->call != list[piece].call || e->at < list[piece].end ||
        w->l->trace->messages[e->message].sent > list[piece].end)
        return false;
    for (size_t i = piece + 1; i < w->pieces.count && list[i].begin < e->at; i++)
        if (list[i].state == TRACE_WAITING && list[i].end > list[i].begin)
            return false;
    return true;
}

/* A part of a piece that belongs to no message. */
static void put_rest(struct writing *w, enum trace_state state, vtime begin, vtime end)
{
    if (begin < end && state == TRACE_WAITING)
        put_event(w, IDLE, begin, end);
    else if (begin < end && (state == TRACE_IN_CALL || state == TRACE_IN_SYSTEM))
        put_event(w, OVERHEAD, begin, end);
}

/* In the system, the time until a message's end is for that message; elsewhere the end takes no time. */
static void put_piece(struct writing *w, size_t piece)
{
    const struct trace_piece *p = &w->pieces.list[piece];
    bool in_system = p->state == TRACE_IN_CALL || p->state == TRACE_IN_SYSTEM;
    const struct timeline_end *e;
    vtime from = p->begin;
    while ((e = next_until(w, in_system ? p->end : vt_max(p->end, 1) - 1))) {
        vtime at = vt_max(e->at, from); /* those before the piece are at its begin */
        if (!in_system)
            put_rest(w, p->state, from, at);
        put_end(w, e, RECEIVE, in_system ? from : at, at);
        from = at;
        w->next++;
    }
    if (p->state == TRACE_WAITING && w->next < w->end_count && waited_for(w, piece, &w->ends[w->next]))
        put_end(w, &w->ends[w->next++], RECEIVE_BLOCKED, from, p->end);
    else
        put_rest(w, p->state, from, p->end);
}

static void put_node(struct writing *w)
{
    static const struct timeline_visitor VISITOR = {NULL, NULL, note_end};
    const struct trace *t = w->l->trace;
    w->pieces.count = w->end_count = w->next = 0;
    timeline_walk(w->l, w->node, &VISITOR, w);
    trace_pieces(t, w->node, &w->pieces);
    in_order_stream(w->lines);
    put(w, BEGIN, TRACED, t->from);
    for (size_t i = 0; i < w->pieces.count; i++)
        put_piece(w, i);
    vtime end = timeline_within(t, t->nodes[w->node].end);
    for (; w->next < w->end_count; w->next++) /* at the very end */
        put_end(w, &w->ends[w->next], RECEIVE, end, end);
    put(w, END, TRACED, end);
}

bool picl_write(const struct timeline *l, FILE *out, const struct export_progress *p, char **error)
{
    struct writing w = {.l = l, .lines = in_order_new(error)};
    if (!w.lines)
        return false;
    for (w.node = 0; w.node < l->trace->node_count; w.node++) {
        if (!l->trace->nodes[w.node].traced)
            continue;
        put_node(&w);
        export_progress_show(p, w.node);
    }
    bool ok = in_order_write(w.lines, out, error);
    free(w.pieces.list);
    free(w.ends);
    in_order_free(w.lines);
    return ok;
}
