/* waits_for.c - see waits_for.h. */
#include "machine/waits_for.h"
#include <stdlib.h>
#include <string.h>
#include "guest/backtrace.h"
#include "guest/image.h"
#include "kernel/xalloc.h"
#include "machine/waits_in_windows.h"
#include "mpi_api/core/completion.h"
#include "notes/taken.h"
#include "nx_api/calls/awaited.h"
#include "os/due.h"
#include "os/end.h"
#include "os/memory.h"

struct filling {
    const struct node_system *s;
    struct waitfor *w;
    struct backtrace_lines *lines;
};

static long number_of(const struct filling *f, uint32_t address)
{
    return (long)node_number(f->s, address);
}

static struct waitfor_select select_of(const struct selector *s)
{
    return (struct waitfor_select){(long)s->type, s->node, s->pid};
}

/* --- where the program is --- */

/* "exchange() at ring.c:17"; NULL: no source line is known, or it is in NX's library. */
static const char *frame_of(const struct filling *f, const struct node *n, uintptr_t returns)
{
    const char *line = backtrace_line_at(f->lines, n, returns);
    const char *function =
        line ? node_image_function_name(n->guest.file, returns - 1 - (uintptr_t)n->guest.program) : NULL;
    if (!line)
        return NULL;
    char *text = function ? xasprintf("%.*s() at %s", (int)strcspn(function, "."), function, line)
                          : xasprintf("%s", line);
    const char *kept = waitfor_text(f->w, text);
    free(text);
    return kept;
}

static void fill_stack(const struct filling *f, const struct node *n, struct waitfor_node *to)
{
    enum { MOST_FRAMES = 24 };
    uintptr_t returns[MOST_FRAMES];
    int depth = backtrace_walk(n, n->wait.frame, returns, MOST_FRAMES);
    for (int i = 0; i < depth; i++) {
        const char *frame = frame_of(f, n, returns[i]);
        if (frame)
            waitfor_add_frame(f->w, to, frame);
    }
    to->line = waitfor_text(f->w, backtrace_line(f->lines, n));
}

/* --- what it waits for --- */

static void fill_send(const struct filling *f, const struct send *s, struct waitfor_node *to)
{
    to->what = WAITFOR_BUFFER;
    to->to = WAITFOR_ANY;
    if (s->m) {
        to->to = number_of(f, s->m->to);
        to->to_bytes = s->m->bytes;
        to->to_held = s->m->held;
    }
}

static void fill_awaited(const struct filling *f, const struct node *n, struct waitfor_node *to)
{
    struct node *of = (struct node *)(uintptr_t)n;
    struct awaited a = n->wait.ready == completion_is_ready ? completion_awaits(of, n->wait.arg)
                                                            : nx_awaited(of, n->wait.ready, n->wait.arg);
    to->what = WAITFOR_FILE; /* nothing else is waited for without an event that is to come */
    if (a.receive || a.probe) {
        to->what = WAITFOR_MESSAGE;
        to->select = select_of(a.receive ? &a.receive->select : a.probe);
    } else if (a.send) {
        fill_send(f, a.send, to);
    } else if (a.end) {
        to->what = WAITFOR_END;
        to->to = a.of == ALL_NODES ? WAITFOR_ANY : a.of;
        to->of_all = a.all && a.of == ALL_NODES;
    }
}

static void fill_call(const struct filling *f, const struct node *n, struct waitfor_node *to)
{
    to->call = n->call.name;
    to->has_type = n->call.has_type;
    to->type = n->call.type;
    to->since_ps = n->call.since;
    fill_awaited(f, n, to);
    fill_stack(f, n, to);
}

/* --- what it has of messages --- */

static void add_messages(const struct filling *f, const struct message *list, struct waitfor_node *to)
{
    for (const struct message *m = list; m; m = m->next)
        waitfor_add_message(to, &(struct waitfor_message){.type = m->type,
                                                          .from = number_of(f, m->source),
                                                          .pid = m->pid,
                                                          .bytes = m->bytes,
                                                          .sent_ps = WAITFOR_NEVER,
                                                          .came_ps = m->arrived ? m->complete : WAITFOR_NEVER,
                                                          .held_back = m->is_long && !m->cleared});
}

/* A receive that is under way, or whose message is here; with a handler, the line is where that begins. */
static void add_receive(const struct filling *f, const struct node *n, const struct receive *r,
                        struct waitfor_node *to)
{
    struct waitfor_receive added = {
        .select = select_of(&r->select), .has_handler = r->handler, .filled = r->m && r->m->arrived};
    if (added.filled) {
        added.type = r->m->type;
        added.from = number_of(f, r->m->source);
    }
    if (r->handler)
        added.line = waitfor_text(f->w, backtrace_line_at(f->lines, n, (uintptr_t)r->handler + 1));
    waitfor_add_receive(to, &added);
}

/* Adds the receives of message ids, and the receives with handlers, posted or due. */
static void add_receives(const struct filling *f, const struct node *n, struct waitfor_node *to)
{
    for (const struct id_block *b = n->mailbox.ids.first; b; b = b->next)
        for (int i = 0; i < IDS_BLOCK; i++)
            if (b->ids[i].use & ID_RECEIVES)
                add_receive(f, n, &b->ids[i].receive, to);
    for (const struct receive *r = n->mailbox.posted.first; r; r = r->next)
        if (r->handler)
            add_receive(f, n, r, to);
    const struct due *last = n->mailbox.last_due, *d = last;
    if (!last)
        return;
    do {
        d = d->next;
        to->due++;
        if (d->receive)
            add_receive(f, n, d->receive, to);
    } while (d != last);
}

/* --- what it had --- */

static enum waitfor_fate fate_of(enum taken_how how)
{
    switch (how) {
    case TAKEN_BY_HANDLER:
        return WAITFOR_HANDLED;
    case TAKEN_BY_FLUSH:
        return WAITFOR_FLUSHED;
    case TAKEN_AS_FORCED:
        return WAITFOR_DISCARDED;
    default:
        return WAITFOR_RECEIVED;
    }
}

static const char *line_of_taken(const struct filling *f, const struct node *n, const struct taken *t)
{
    return waitfor_text(f->w, backtrace_line_of(f->lines, n, t->at, TAKEN_CALLS));
}

static void add_taken(const struct filling *f, const struct node *n, const struct taken_ring *r,
                      struct waitfor_node *to)
{
    const struct taken *t;
    for (uint32_t k = 0; (t = taken_get(r, k)); k++)
        waitfor_add_taken(to, &(struct waitfor_taken){.fate = fate_of(t->how),
                                                      .type = t->type,
                                                      .from = number_of(f, t->source),
                                                      .pid = t->pid,
                                                      .bytes = t->bytes,
                                                      .by = select_of(&t->by),
                                                      .call = t->call,
                                                      .line = line_of_taken(f, n, t),
                                                      .came_ps = t->came});
}

/* --- a node --- */

static void fill_mailbox(const struct filling *f, const struct node *n, struct waitfor_node *to)
{
    to->masked = n->handlers.masked, to->in_handler = n->in_handler;
    to->buffered_bytes = n->memory.buffered;
    size_t others = node_memory_used(n) - n->memory.buffered, limit = node_memory_limit(n);
    to->buffer_bytes = limit > others ? limit - others : 0;
    add_messages(f, n->mailbox.whole, to);
    add_messages(f, n->unexpected.coming, to);
    add_receives(f, n, to);
    const struct taken_log *taken = taken_of(n);
    if (taken) {
        add_taken(f, n, &taken->by_program, to);
        add_taken(f, n, &taken->lost, to);
    }
}

static void fill(const struct filling *f, const struct node *n, struct waitfor_node *to)
{
    to->name = waitfor_text(f->w, n->cold->name);
    to->is_host = n->is_host;
    if (n->end.how == NODE_NOT_LOADED) {
        to->state = WAITFOR_NO_PROGRAM;
        return;
    }
    if (n->lp.state == LP_ENDED) {
        to->state = WAITFOR_ENDED;
        to->since_ps = n->stats.ended_at;
        to->exit_status = node_exited_badly(n) ? n->end.exit_code : 0;
        if (to->exit_status)
            to->line =
                waitfor_text(f->w, backtrace_line_of(f->lines, n, n->cold->exit_calls, NODE_EXIT_CALLS));
        return;
    }
    to->state = n->call.name ? WAITFOR_WAITS : WAITFOR_COMPUTES;
    if (n->call.name)
        fill_call(f, n, to);
    fill_mailbox(f, n, to);
}

/* Does a program of the nodes know of a host? */
static bool knows_host(const struct node_system *s)
{
    const struct node_image *before = NULL;
    for (uint32_t i = 0; i < s->count; i++) {
        const struct node_image *image = s->nodes[i]->guest.file;
        if (image != before && node_image_uses(image, "myhost"))
            return true;
        before = image;
    }
    return false;
}

struct waitfor *waits_for(const struct node_system *s)
{
    struct waitfor *w = waitfor_new(s->count + (s->host != NULL));
    struct filling f = {s, w, backtrace_lines_new()};
    w->may_lack_host = !s->host && s->cfg->host.clock_hz && !s->messages && knows_host(s);
    for (uint32_t i = 0; i < s->count; i++) {
        fill(&f, s->nodes[i], &w->nodes[i]);
        w->now_ps = vt_max(w->now_ps, s->nodes[i]->stats.ended_at);
    }
    if (s->host)
        fill(&f, s->host, &w->nodes[s->count]);
    backtrace_lines_free(f.lines);
    waits_in_windows(s, w);
    waitfor_analyse(w);
    return w;
}
