/* chrome_json.c - a trace in Chrome's trace event format: "Trace Event Format", Google, 2016, which
 * ui.perfetto.dev and chrome://tracing read.
 *
 * A node is a thread, and each slice a pair of ph B and E; a message is an arrow by s and f, between the
 * slice that sent it and the one that took it. Times are microseconds with six digits behind the point, that
 * is picoseconds. ph X, which would be one event a slice, gives a time and a duration: a reader that adds
 * them as floating-point numbers, or rounds each to nanoseconds as Perfetto does, finds slices that
 * overlap. */
#include "lab/export/chrome_json.h"
#include <stdlib.h>
#include <string.h>
#include "files/text_file.h"
#include "kernel/xalloc.h"
#include "lab/export/decimal.h"

struct writing {
    const struct timeline *l;
    FILE *out;
    int32_t node;
    bool begun; /* an event has been written */
    bool args;  /* an argument of this event has */
};

/* Bytes that are not UTF-8 become '?': a source may be called so. */
static void put_text(FILE *out, const char *text)
{
    fputc('"', out);
    for (size_t length; *text; text += length ? length : 1) {
        length = text_character(text);
        if (*text == '"' || *text == '\\')
            fprintf(out, "\\%c", *text);
        else if ((unsigned char)*text < ' ')
            fprintf(out, "\\u%04x", *text);
        else if (length)
            fwrite(text, 1, length, out);
        else
            fputc('?', out);
    }
    fputc('"', out);
}

/* Threads are numbered from 1: to Perfetto, thread 0 is what an idle processor runs. */
static void begin_event(struct writing *w, const char *ph)
{
    fprintf(w->out, "%s{\"ph\":\"%s\",\"pid\":1,\"tid\":%d", w->begun ? ",\n" : "", ph, w->node + 1);
    w->begun = true;
    w->args = false;
}

static void begin_event_at(struct writing *w, const char *ph, vtime at)
{
    begin_event(w, ph);
    fprintf(w->out, ",\"ts\":%" PRI_MICROSECONDS, MICROSECONDS(at));
}

static void name_argument(struct writing *w, const char *name)
{
    fprintf(w->out, "%s\"%s\":", w->args ? "," : ",\"args\":{", name);
    w->args = true;
}

static void number_argument(struct writing *w, const char *name, int64_t value)
{
    name_argument(w, name);
    fprintf(w->out, "%" PRId64, value);
}

static void text_argument(struct writing *w, const char *name, const char *text)
{
    name_argument(w, name);
    put_text(w->out, text);
}

static void time_argument(struct writing *w, const char *name, vtime t)
{
    if (t == VT_NEVER)
        return;
    name_argument(w, name);
    fprintf(w->out, "%" PRI_MICROSECONDS, MICROSECONDS(t));
}

static void end_event(struct writing *w)
{
    fputs(w->args ? "}}" : "}", w->out);
}

/* --- what slices say of themselves --- */

static const char *node_name(const struct trace *t, int32_t node)
{
    return node == TRACE_NONE ? "a service" : t->nodes[node].name;
}

static vtime blocked(const struct trace *t, const struct trace_message *m)
{
    vtime sum = 0;
    for (int32_t i = 0; i < m->blocks; i++)
        sum += t->blocks[m->first_block + i].end - t->blocks[m->first_block + i].begin;
    return sum;
}

static void place_arguments(struct writing *w, int32_t stack)
{
    const struct trace_frame *f = stack == TRACE_NONE ? NULL : trace_place(w->l->trace, stack);
    if (!f)
        return;
    text_argument(w, "function", f->function);
    if (f->file) {
        text_argument(w, "file", f->file);
        number_argument(w, "line", f->line);
    }
}

static void message_arguments(struct writing *w, int32_t message)
{
    const struct trace_message *m = &w->l->trace->messages[message];
    char *communicator = trace_communicator(m->pid);
    number_argument(w, "message", message);
    if (communicator)
        text_argument(w, "communicator", communicator);
    free(communicator);
    number_argument(w, "bytes", (int64_t)m->bytes);
}

static void sent_arguments(struct writing *w, const struct trace_call *c)
{
    if (c->sent == TRACE_NONE)
        return;
    message_arguments(w, c->sent);
    text_argument(w, "to", node_name(w->l->trace, w->l->trace->messages[c->sent].to));
}

static void taken_arguments(struct writing *w, int32_t message)
{
    const struct trace *t = w->l->trace;
    if (message == TRACE_NONE)
        return;
    const struct trace_message *m = &t->messages[message];
    message_arguments(w, message);
    int32_t sender = timeline_sender(w->l, message);
    text_argument(w, "from", node_name(t, sender));
    if (m->from != sender)
        text_argument(w, "by_way_of", node_name(t, m->from));
    number_argument(w, "message_type", m->type);
    time_argument(w, "sent_us", m->sent);
    time_argument(w, "complete_us", m->complete);
    time_argument(w, "blocked_us", blocked(t, m));
}

static void call_arguments(struct writing *w, int32_t call)
{
    const struct trace *t = w->l->trace;
    const struct trace_call *c = &t->calls[call];
    const char *called = trace_called_name(t, c);
    if (c->has_type)
        number_argument(w, trace_takes_id(t, c) ? "id" : "type", c->type);
    if (strcmp(called, t->names[c->name]) != 0)
        text_argument(w, "called", called);
    if (c->unfinished)
        text_argument(w, "unfinished", "the run, or the trace, ended in this call");
    place_arguments(w, c->stack);
    if (c->sent != TRACE_NONE)
        sent_arguments(w, c);
    else
        taken_arguments(w, c->taken);
}

static void wait_arguments(struct writing *w, int32_t wait)
{
    const struct trace_wait *of = &w->l->trace->waits[wait];
    text_argument(w, "until", of->sends ? "a message has left" : "a message comes");
    if (of->has_type)
        number_argument(w, "type", of->type);
    if (of->from != TRACE_NONE)
        text_argument(w, "from", node_name(w->l->trace, of->from));
}

static void handler_arguments(struct writing *w, int32_t handler)
{
    const struct trace_handler *h = &w->l->trace->handlers[handler];
    number_argument(w, "type", h->type);
    time_argument(w, "due_us", h->due);
    taken_arguments(w, h->message);
}

static void slice_arguments(struct writing *w, const struct timeline_slice *s)
{
    if (s->index == TRACE_NONE)
        return;
    if (s->kind == TIMELINE_CALL)
        call_arguments(w, s->index);
    else if (s->kind == TIMELINE_HANDLER)
        handler_arguments(w, s->index);
    else if (s->kind == TIMELINE_LIBRARY)
        place_arguments(w, w->l->trace->calls[s->index].stack);
    else if (s->kind == TIMELINE_WAITING)
        wait_arguments(w, s->index);
}

/* --- a walk --- */

static void enter(void *ctx, const struct timeline_slice *s)
{
    static const char *const CATEGORIES[] = {"computing", "waiting", "system", "call", "handler", "MPI"};
    struct writing *w = ctx;
    begin_event_at(w, "B", s->begin);
    fprintf(w->out, ",\"cat\":\"%s\",\"name\":", CATEGORIES[s->kind]);
    put_text(w->out, timeline_name(w->l->trace, s));
    slice_arguments(w, s);
    end_event(w);
}

static void leave(void *ctx, const struct timeline_slice *s)
{
    struct writing *w = ctx;
    begin_event_at(w, "E", s->end);
    fputs(",\"name\":", w->out); /* not needed by the format, but by some readers */
    put_text(w->out, timeline_name(w->l->trace, s));
    end_event(w);
}

static void message(void *ctx, const struct timeline_end *e)
{
    struct writing *w = ctx;
    if (!timeline_has_ends(w->l, e->message))
        return;
    begin_event_at(w, e->taken ? "f" : "s", e->at);
    fprintf(w->out, ",\"cat\":\"message\",\"name\":\"message\",\"id\":%d%s", e->message,
            e->taken ? ",\"bp\":\"e\"" : "");
    number_argument(w, "type", w->l->trace->messages[e->message].type);
    number_argument(w, "bytes", (int64_t)w->l->trace->messages[e->message].bytes);
    end_event(w);
}

static void name_threads(struct writing *w)
{
    const struct trace *t = w->l->trace;
    begin_event(w, "M");
    fputs(",\"name\":\"process_name\"", w->out);
    char *name = xasprintf("%s on %s", basename(t->program), t->machine);
    text_argument(w, "name", name);
    free(name);
    end_event(w);
    for (w->node = 0; w->node < t->node_count; w->node++) {
        if (!t->nodes[w->node].traced)
            continue;
        begin_event(w, "M");
        fputs(",\"name\":\"thread_name\"", w->out);
        text_argument(w, "name", t->nodes[w->node].name);
        end_event(w);
        begin_event(w, "M");
        fputs(",\"name\":\"thread_sort_index\"", w->out);
        number_argument(w, "sort_index", w->node);
        end_event(w);
    }
}

/* What the whole trace is of, for people who look at the file. */
static void put_head(const struct trace *t, FILE *out)
{
    const char *const said[][2] = {{"program", t->program},
                                   {"machine", t->machine},
                                   {"command", t->command},
                                   {"touchstone", t->version}};
    fputs("{\"displayTimeUnit\":\"ns\",\"otherData\":{", out);
    for (size_t i = 0; i < sizeof said / sizeof *said; i++) {
        fprintf(out, "\"%s\":", said[i][0]);
        put_text(out, said[i][1] ? said[i][1] : "");
        fputc(',', out);
    }
    fprintf(out, "\"digest\":\"%016" PRIx64 "\"},\n\"traceEvents\":[\n", t->digest);
}

bool chrome_json_write(const struct timeline *l, FILE *out, const struct export_progress *p, char **error)
{
    static const struct timeline_visitor VISITOR = {enter, leave, message};
    struct writing w = {.l = l, .out = out};
    (void)error;
    put_head(l->trace, out);
    name_threads(&w);
    for (w.node = 0; w.node < l->trace->node_count && !ferror(out); w.node++) {
        timeline_walk(l, w.node, &VISITOR, &w);
        export_progress_show(p, w.node);
    }
    fputs("\n]}\n", out);
    return true;
}
