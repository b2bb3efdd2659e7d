/* waitfor_write_json.c - a report for programs. doc/deadlocks.md describes the form. */
#include <inttypes.h>
#include "nx_api/waitfor/waitfor_parts.h"

static bool is_plain(unsigned char c)
{
    return c >= ' ' && c < 0x80 && c != '"' && c != '\\';
}

static void put_special(FILE *f, unsigned char c)
{
    if (c == '"' || c == '\\')
        fprintf(f, "\\%c", c);
    else if (c == '\n')
        fputc(' ', f);
    else if (c < ' ')
        fprintf(f, "\\u%04x", c);
    else
        fputc('?', f); /* other than ASCII may be no UTF-8 */
}

/* Writes plain characters as one: of many nodes, each may have a list of the others. */
static void put_text(FILE *f, const char *text)
{
    if (!text) {
        fputs("null", f);
        return;
    }
    fputc('"', f);
    for (;;) {
        const char *begin = text;
        while (is_plain((unsigned char)*text))
            text++;
        fwrite(begin, 1, (size_t)(text - begin), f);
        if (!*text)
            break;
        put_special(f, (unsigned char)*text++);
    }
    fputc('"', f);
}

/* ", "NAME": " and the value */
static void put_string(FILE *f, const char *name, const char *text)
{
    fprintf(f, ", \"%s\": ", name);
    put_text(f, text);
}

static void put_number(FILE *f, const char *name, long value)
{
    fprintf(f, ", \"%s\": %ld", name, value);
}

static void put_bytes(FILE *f, const char *name, uint64_t value)
{
    fprintf(f, ", \"%s\": %" PRIu64, name, value);
}

static void put_bool(FILE *f, const char *name, bool value)
{
    fprintf(f, ", \"%s\": %s", name, value ? "true" : "false");
}

static void put_time(FILE *f, const char *name, uint64_t ps)
{
    if (ps == WAITFOR_NEVER)
        fprintf(f, ", \"%s\": null", name);
    else
        put_bytes(f, name, ps);
}

static void put_select(FILE *f, const struct waitfor_select *s)
{
    fprintf(f, "{\"typesel\": %ld, \"node\": %ld, \"pid\": %ld}", s->typesel, s->node, s->pid);
}

static void put_messages(FILE *f, const struct waitfor_node *n)
{
    fputs(", \"messages\": [", f);
    for (size_t i = 0; i < n->message_count; i++) {
        const struct waitfor_message *m = &n->messages[i];
        fprintf(f, "%s{\"type\": %ld, \"from\": %ld, \"pid\": %ld", i ? ", " : "", m->type, m->from, m->pid);
        put_bytes(f, "bytes", m->bytes);
        put_time(f, "sent_ps", m->sent_ps);
        put_time(f, "came_ps", m->came_ps);
        put_bool(f, "held_back", m->held_back);
        fputc('}', f);
    }
    fprintf(f, "], \"more_messages\": %" PRIu64, n->more_messages);
}

static void put_receives(FILE *f, const struct waitfor_node *n)
{
    fputs(", \"receives\": [", f);
    for (size_t i = 0; i < n->receive_count; i++) {
        const struct waitfor_receive *r = &n->receives[i];
        fprintf(f, "%s{\"select\": ", i ? ", " : "");
        put_select(f, &r->select);
        put_bool(f, "has_handler", r->has_handler);
        put_bool(f, "filled", r->filled);
        if (r->filled) {
            put_number(f, "type", r->type);
            put_number(f, "from", r->from);
        }
        put_string(f, "line", r->line);
        fputc('}', f);
    }
    fputc(']', f);
}

static void put_taken(FILE *f, const struct waitfor_node *n)
{
    static const char *const FATES[] = {"received", "handled", "flushed", "discarded"};
    fputs(", \"taken\": [", f);
    for (size_t i = 0; i < n->taken_count; i++) {
        const struct waitfor_taken *t = &n->taken[i];
        fprintf(f, "%s{\"fate\": \"%s\"", i ? ", " : "", FATES[t->fate]);
        put_number(f, "type", t->type);
        put_number(f, "from", t->from);
        put_number(f, "pid", t->pid);
        put_bytes(f, "bytes", t->bytes);
        fputs(", \"by\": ", f);
        put_select(f, &t->by);
        put_string(f, "call", t->call);
        put_string(f, "line", t->line);
        put_time(f, "came_ps", t->came_ps);
        fputc('}', f);
    }
    fputc(']', f);
}

static void put_waits_for(FILE *f, const struct waitfor_node *n)
{
    static const char *const WHATS[] = {"message", "buffer", "end", "handler", "other", "file"};
    fprintf(f, ", \"waits_for\": {\"what\": \"%s\"", WHATS[n->what]);
    if (n->what == WAITFOR_MESSAGE) {
        fputs(", \"select\": ", f);
        put_select(f, &n->select);
        put_string(f, "operation", n->operation);
    } else if (n->what == WAITFOR_BUFFER || n->what == WAITFOR_END) {
        put_number(f, "to", n->to);
    }
    if (n->what == WAITFOR_BUFFER)
        put_bytes(f, "bytes", n->to_bytes);
    if (n->what == WAITFOR_END)
        put_bool(f, "of_all", n->of_all);
    fputc('}', f);
}

/* The nodes that could end the wait; of a global operation, those that it waits for. */
static void put_who(FILE *f, const struct waitfor_node *n)
{
    static const char *const WHO[] = {"nobody", "one", "any", "all"};
    put_string(f, "who", WHO[n->who]);
    if (n->who == WAITFOR_ONE_NODE)
        put_number(f, "whom", n->whom);
}

static void put_finding(FILE *f, const struct waitfor_node *n)
{
    put_waits_for(f, n);
    put_who(f, n);
    put_bool(f, "in_cycle", n->in_cycle);
    put_string(f, "cause", waitfor_cause_name(n->cause));
    put_string(f, "why", n->why);
    put_string(f, "remedy", n->remedy);
}

static void put_node(FILE *f, const struct waitfor_node *n)
{
    static const char *const STATES[] = {"no program", "waits", "computes", "ended"};
    fprintf(f, "  {\"number\": %ld", n->number);
    put_string(f, "name", n->name);
    put_string(f, "state", STATES[n->state]);
    put_string(f, "call", n->call);
    if (n->has_type)
        put_number(f, "type", n->type);
    put_time(f, "since_ps", n->since_ps);
    if (n->exit_status)
        put_number(f, "exit_status", n->exit_status);
    put_string(f, "line", n->line);
    fputs(", \"stack\": [", f);
    for (size_t i = 0; i < n->stack_count; i++) {
        fputs(i ? ", " : "", f);
        put_text(f, n->stack[i]);
    }
    fputc(']', f);
    if (n->state == WAITFOR_WAITS)
        put_finding(f, n);
    put_bool(f, "masked", n->masked);
    put_bool(f, "in_handler", n->in_handler);
    put_number(f, "due", n->due);
    put_bytes(f, "buffered_bytes", n->buffered_bytes);
    put_bytes(f, "buffer_bytes", n->buffer_bytes);
    put_messages(f, n);
    put_receives(f, n);
    put_taken(f, n);
    fputc('}', f);
}

void waitfor_write_json(const struct waitfor *w, FILE *f)
{
    fputs("{\"version\": 1", f);
    put_string(f, "program", w->program);
    put_string(f, "clock", w->clock);
    put_bytes(f, "now_ps", w->now_ps);
    fputs(", \"cycle\": [", f);
    for (uint32_t k = 0; k < w->cycle_count; k++)
        fprintf(f, "%s%u", k ? ", " : "", w->cycle[k]);
    fputs("]", f);
    put_bool(f, "knot", w->knot);
    fputs(", \"nodes\": [\n", f);
    for (uint32_t i = 0; i < w->count; i++) {
        put_node(f, &w->nodes[i]);
        fputs(i + 1 < w->count ? ",\n" : "\n", f);
    }
    fputs("]}", f);
}
