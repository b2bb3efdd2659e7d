/* schedule_record.c - see schedule_record.h. */
#include "replay/schedule_record.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "files/text_file.h"
#include "kernel/xalloc.h"
#include "os/order.h"

static FILE *out_of(const struct node *n)
{
    return n->sys->numbering->out;
}

/* A node's number, or "host": by its index. */
static void put_node(FILE *f, const struct numbering *b, uint32_t index)
{
    if (index == b->nodes)
        fputs(" host", f);
    else
        fprintf(f, " %u", index);
}

/* "match 3", of the node n. */
static void put_begin(const struct node *n, const char *what)
{
    fputs(what, out_of(n));
    put_node(out_of(n), n->sys->numbering, numbering_index(n->sys, n->lp.address));
}

static void put_time(FILE *f, const char *key, vtime t)
{
    if (t != VT_NEVER)
        fprintf(f, " %s=%" PRIu64, key, t);
}

/* A word of UTF-8: blanks would end it, and other bytes would be no text (timing/plan_read.h). */
static void put_text(FILE *f, const char *key, const char *text)
{
    if (!text)
        return;
    fprintf(f, " %s=", key);
    for (size_t n; *text; text += n ? n : 1) {
        n = strchr(" \t\n#", *text) ? 0 : text_character(text);
        fprintf(f, "%.*s", n ? (int)n : 1, n ? text : "_");
    }
}

/* --- the head --- */

static void put_timing(const struct node_system *s, uint32_t index, uint32_t timed)
{
    const struct numbering *b = s->numbering;
    if (timing_speed(s->timing, timed)) {
        fputs("speed", b->out);
        put_node(b->out, b, index);
        fprintf(b->out, " %" PRIu32 "\n", timing_speed(s->timing, timed));
    }
    if (timing_start(s->timing, timed)) {
        fputs("start", b->out);
        put_node(b->out, b, index);
        fprintf(b->out, " %" PRIu64 "\n", timing_start(s->timing, timed));
    }
}

void schedule_record_begin(const struct node_system *s, const char *drawn, const char *file, uint32_t program)
{
    const char *slash = strrchr(file, '/');
    const struct numbering *b = s->numbering;
    fprintf(b->out, "touchstone-schedule 1\n");
    if (drawn)
        fprintf(b->out, "# --timing %s\n", drawn);
    fprintf(b->out, "program %" PRIu32, program);
    put_text(b->out, "file", slash ? slash + 1 : file);
    fprintf(b->out, "\nnodes %u\n%s\n", b->nodes, b->plan ? "orders" : "delays");
    for (uint32_t i = 0; i < b->nodes + (s->host != NULL) && s->timing; i++)
        put_timing(s, i, i == b->nodes ? TIMING_HOST : i);
}

/* --- what happens --- */

void schedule_record_send(const struct node *n, const struct message *first, vtime late)
{
    const struct message_number *number = protocol_number_of(first);
    FILE *f = out_of(n);
    put_begin(n, "message");
    fprintf(f, " %" PRIu64 " %" PRIu64 " to=", number->index, late);
    if (first->next || protocol_forwards(first))
        fputs("all", f);
    else
        fprintf(f, "%u", numbering_index(n->sys, first->to));
    fprintf(f, " type=%" PRId32 " bytes=%zu sent=%" PRIu64 "\n", first->type, first->bytes, number->sent);
}

static void put_message(FILE *f, const struct message_number *number, int32_t type, size_t bytes)
{
    put_time(f, "sent", number->sent);
    put_time(f, "came", number->came);
    fprintf(f, " type=%" PRId32 " bytes=%zu", type, bytes);
}

void schedule_record_match(const struct node *n, const struct numbered_receive *r, vtime at)
{
    FILE *f = out_of(n);
    put_begin(n, "match");
    fprintf(f, " %" PRIu64, r->number);
    put_node(f, n->sys->numbering, r->from);
    fprintf(f, " %" PRIu64 " i=%" PRIu64 " posted=%" PRIu64, r->message.nth, r->message.index, r->posted);
    put_time(f, "at", at);
    put_message(f, &r->message, r->type, r->bytes);
    fprintf(f, " typesel=%" PRId64 " sel=%ld", r->select.type, r->select.node);
    put_text(f, "call", r->call);
    put_text(f, "line", r->line);
    fputc('\n', f);
}

void schedule_record_interrupt(const struct node *n, uint64_t k, vtime due, vtime late)
{
    put_begin(n, "interrupt");
    fprintf(out_of(n), " %" PRIu64 " %" PRIu64 " due=%" PRIu64 "\n", k, late, due);
}

void schedule_record_handler(struct node *n, uint64_t k, vtime due, const struct numbered_receive *r,
                             const char *line)
{
    FILE *f = out_of(n);
    put_begin(n, "handler");
    fprintf(f, " %" PRIu64 " %" PRIu64 " at=%" PRIu64 " due=%" PRIu64, k, numbering_node(n)->calls,
            node_now(n), due);
    if (r)
        fprintf(f, " match=%" PRIu64, r->number);
    put_text(f, "line", line);
    fputc('\n', f);
}

/* --- the end --- */

/* Messages that no receive has selected. */
struct left {
    const struct message **list;
    size_t count, room;
};

static void add(struct left *l, const struct message *m)
{
    if (m->serves || m->receive || m->unwanted)
        return;
    if (l->count == l->room) {
        l->room = l->room ? 2 * l->room : 16;
        l->list = xreallocarray(l->list, l->room, sizeof *l->list);
    }
    l->list[l->count++] = m;
}

static int by_number(const void *a, const void *b)
{
    const struct message *x = *(const struct message *const *)a, *y = *(const struct message *const *)b;
    uint64_t i = protocol_number_of(x)->nth, j = protocol_number_of(y)->nth;
    return x->source != y->source ? (x->source > y->source) - (x->source < y->source) : (i > j) - (i < j);
}

static void put_left(const struct node *n, const struct left *l)
{
    const struct numbering *b = n->sys->numbering;
    for (size_t i = 0; i < l->count; i++) {
        const struct message *m = l->list[i];
        const struct message_number *number = protocol_number_of(m);
        put_begin(n, "left");
        put_node(b->out, b, numbering_index(n->sys, m->source));
        fprintf(b->out, " %" PRIu64 " i=%" PRIu64, number->nth, number->index);
        put_message(b->out, number, m->type, m->bytes);
        fputc('\n', b->out);
    }
}

static void end_node(const struct node *n)
{
    struct left l = {0};
    for (const struct message *m = n->mailbox.whole; m; m = m->next)
        add(&l, m);
    for (const struct message *m = n->unexpected.coming; m; m = m->next)
        if (m->arrived)
            add(&l, m);
    for (struct message *m = protocol_to(n->sys->schedule.protocol, n->lp.address); m;
         m = protocol_next_to(m))
        add(&l, m);
    if (l.count)
        qsort(l.list, l.count, sizeof *l.list, by_number);
    put_left(n, &l);
    free(l.list);
}

void schedule_record_end(const struct node_system *s)
{
    for (uint32_t i = 0; i < s->numbering->nodes; i++)
        end_node(s->nodes[i]);
    if (s->host)
        end_node(s->host);
}
