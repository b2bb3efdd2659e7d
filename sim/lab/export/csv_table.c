/* csv_table.c - the tables of a trace as comma-separated values (RFC 4180, but lines end as on Unix). The
 * first line names the columns; those of times end in _s and are seconds, with twelve digits behind the
 * point. What is not known, or did not happen, is empty. Rows of `calls` and `messages` are numbered: other
 * tables refer to them. */
#include "lab/export/csv_table.h"
#include <stdlib.h>
#include <string.h>
#include "lab/export/decimal.h"

/* --- cells: each writes a comma behind itself, but the last of a row --- */

static void put_time(FILE *out, vtime t)
{
    if (t != VT_NEVER)
        fprintf(out, "%" PRI_SECONDS, SECONDS(t));
    fputc(',', out);
}

static void put_span(FILE *out, vtime begin, vtime end)
{
    put_time(out, begin);
    put_time(out, end);
}

static void put_text(FILE *out, const char *text)
{
    bool quoted = text[strcspn(text, ",\"\r\n")] != '\0';
    if (quoted)
        fputc('"', out);
    for (const char *c = text; *c; c++)
        fprintf(out, *c == '"' ? "\"%c" : "%c", *c);
    fputs(quoted ? "\"," : ",", out);
}

static void put_index(FILE *out, int32_t i)
{
    if (i != TRACE_NONE)
        fprintf(out, "%d", i);
    fputc(',', out);
}

static void put_number(FILE *out, bool known, int64_t number)
{
    if (known)
        fprintf(out, "%" PRId64, number);
    fputc(',', out);
}

static void put_node(FILE *out, const struct trace *t, int32_t node)
{
    put_text(out, node == TRACE_NONE ? "" : t->nodes[node].name);
}

static void put_call_name(FILE *out, const struct trace *t, int32_t call)
{
    put_text(out, call == TRACE_NONE ? "" : t->names[t->calls[call].name]);
}

/* Ends the row. */
static void put_place(FILE *out, const struct trace *t, int32_t stack)
{
    const struct trace_frame *f = stack == TRACE_NONE ? NULL : trace_place(t, stack);
    put_text(out, f ? f->function : "");
    put_text(out, f && f->file ? f->file : "");
    if (f && f->file)
        fprintf(out, "%d", f->line);
    fputc('\n', out);
}

/* --- tables --- */

static void put_pieces(const struct trace *t, FILE *out, const struct export_progress *p)
{
    struct trace_pieces pieces = {0};
    fputs("node,begin_s,end_s,state,call,call_name,in_handler\n", out);
    for (int32_t n = 0; n < t->node_count; n++) {
        pieces.count = 0;
        if (t->nodes[n].traced)
            trace_pieces(t, n, &pieces);
        for (const struct trace_piece *x = pieces.list; x < pieces.list + pieces.count; x++) {
            put_node(out, t, n);
            put_span(out, x->begin, x->end);
            put_text(out, trace_state_name(x->state));
            put_index(out, x->call);
            put_call_name(out, t, x->call);
            fprintf(out, "%d\n", x->in_handler);
        }
        export_progress_show(p, n);
    }
    free(pieces.list);
}

static void put_calls(const struct trace *t, FILE *out, const struct export_progress *p)
{
    fputs("call,node,begin_s,end_s,name,called,type,in_handler,unfinished,first_message_sent,"
          "last_message_taken,function,file,line\n",
          out);
    for (const struct trace_call *c = t->calls; c < t->calls + t->call_count; c++) {
        export_progress_rows(p, (size_t)(c - t->calls), (size_t)t->call_count);
        put_index(out, (int32_t)(c - t->calls));
        put_node(out, t, c->node);
        put_span(out, c->begin, c->unfinished ? VT_NEVER : c->end);
        put_text(out, t->names[c->name]);
        put_text(out, trace_called_name(t, c));
        put_number(out, c->has_type && !trace_takes_id(t, c), c->type);
        fprintf(out, "%d,%d,", c->in_handler, c->unfinished);
        put_index(out, c->sent);
        put_index(out, c->taken);
        put_place(out, t, c->stack);
    }
}

static void put_waits(const struct trace *t, FILE *out, const struct export_progress *p)
{
    fputs("node,begin_s,end_s,idle_s,call,call_name,type,from,until\n", out);
    for (const struct trace_wait *w = t->waits; w < t->waits + t->wait_count; w++) {
        export_progress_rows(p, (size_t)(w - t->waits), (size_t)t->wait_count);
        put_node(out, t, w->node);
        put_span(out, w->begin, w->end);
        put_time(out, w->idle);
        put_index(out, w->call);
        put_call_name(out, t, w->call);
        put_number(out, w->has_type, w->type);
        put_node(out, t, w->from);
        fputs(w->sends ? "a message has left\n" : "a message comes\n", out);
    }
}

static void put_handlers(const struct trace *t, FILE *out, const struct export_progress *p)
{
    fputs("node,due_s,begin_s,entered_s,left_s,end_s,type,message,unfinished,function,file,line\n", out);
    for (const struct trace_handler *h = t->handlers; h < t->handlers + t->handler_count; h++) {
        export_progress_rows(p, (size_t)(h - t->handlers), (size_t)t->handler_count);
        put_node(out, t, h->node);
        put_time(out, h->due);
        put_span(out, h->begin, h->entered);
        put_span(out, h->left, h->unfinished ? VT_NEVER : h->end);
        put_number(out, true, h->type);
        put_index(out, h->message);
        fprintf(out, "%d,", h->unfinished);
        put_place(out, t, h->stack);
    }
}

static void put_systems(const struct trace *t, FILE *out, const struct export_progress *p)
{
    static const char *const TASKS[] = {[TRACE_SENDING] = "sending",
                                        [TRACE_RECEIVING] = "receiving",
                                        [TRACE_FEEDING] = "feeding",
                                        [TRACE_EMPTYING] = "emptying"};
    fputs("node,begin_s,end_s,task\n", out);
    for (const struct trace_system *s = t->systems; s < t->systems + t->system_count; s++) {
        export_progress_rows(p, (size_t)(s - t->systems), (size_t)t->system_count);
        put_node(out, t, s->node);
        put_span(out, s->begin, s->end);
        fprintf(out, "%s\n", TASKS[s->task]);
    }
}

static void put_messages(const struct trace *t, FILE *out, const struct export_progress *p)
{
    fputs(
        "message,from,to,from_address,to_address,type,bytes,long,sent_s,asked_s,granted_s,entered_s,moved_s,"
        "freed_s,left_s,complete_s,taken_s,sending_call,taking_call,blocks\n",
        out);
    for (const struct trace_message *m = t->messages; m < t->messages + t->message_count; m++) {
        export_progress_rows(p, (size_t)(m - t->messages), (size_t)t->message_count);
        put_index(out, (int32_t)(m - t->messages));
        put_node(out, t, m->from);
        put_node(out, t, m->to);
        fprintf(out, "%" PRIu32 ",%" PRIu32 ",%" PRId32 ",%" PRIu64 ",%d,", m->from_address, m->to_address,
                m->type, m->bytes, m->is_long);
        const vtime times[] = {m->sent,  m->asked, m->granted,  m->entered, m->moved,
                               m->freed, m->left,  m->complete, m->taken};
        for (size_t i = 0; i < sizeof times / sizeof *times; i++)
            put_time(out, times[i]);
        put_index(out, m->sending);
        put_index(out, m->taking);
        fprintf(out, "%" PRId32 "\n", m->blocks);
    }
}

static void put_blocks(const struct trace *t, FILE *out, const struct export_progress *p)
{
    char name[128];
    fputs("message,begin_s,end_s,channel,channel_name\n", out);
    for (const struct trace_block *b = t->blocks; b < t->blocks + t->block_count; b++) {
        export_progress_rows(p, (size_t)(b - t->blocks), (size_t)t->block_count);
        put_index(out, b->message);
        put_span(out, b->begin, b->end);
        fprintf(out, "%" PRIu32 ",%s\n", b->channel, trace_channel_name(t, b->channel, name, sizeof name));
    }
}

void csv_table_write(const struct trace *t, enum export_table table, FILE *out,
                     const struct export_progress *p)
{
    static void (*const WRITE[])(const struct trace *t, FILE *out, const struct export_progress *p) = {
        [EXPORT_PIECES] = put_pieces,     [EXPORT_CALLS] = put_calls,     [EXPORT_WAITS] = put_waits,
        [EXPORT_HANDLERS] = put_handlers, [EXPORT_SYSTEMS] = put_systems, [EXPORT_MESSAGES] = put_messages,
        [EXPORT_BLOCKS] = put_blocks};
    WRITE[table](t, out, p);
}
