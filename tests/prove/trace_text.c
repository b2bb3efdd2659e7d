/* trace_text.c - see trace_text.h. Numbers of names and stacks are left out: they depend on the order in which the file
 * has them. */
#include "trace_text.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "lab/trace/trace_model.h"

static void print_calls(const struct trace *t, FILE *f)
{
    for (const struct trace_call *c = t->calls; c < t->calls + t->call_count; c++) {
        fprintf(f, "call node %d %s %" PRIu64 " %" PRIu64 " %" PRIu64 " type %d %d%s%s sent %d taken %d\n",
                c->node, t->names[c->name], c->begin, c->ordered, c->end, c->has_type, c->type,
                c->unfinished ? " unfinished" : "", c->in_handler ? " in handler" : "", c->sent, c->taken);
        for (const struct trace_wait *w = t->waits + c->first_wait; w < t->waits + c->first_wait + c->waits;
             w++)
            fprintf(f, "  wait %" PRIu64 " %" PRIu64 " idle %" PRIu64 " type %d %d sends %d from %d\n",
                    w->begin, w->end, w->idle, w->has_type, w->type, w->sends, w->from);
    }
}

static void print_messages(const struct trace *t, FILE *f)
{
    for (const struct trace_message *m = t->messages; m < t->messages + t->message_count; m++) {
        fprintf(f,
                "message %u %u type %d bytes %" PRIu64 " %" PRId64 " %" PRId64 " %" PRId64 " %" PRId64
                " %" PRId64 " %" PRId64 " %" PRId64 " %" PRId64 " %" PRId64 " calls %d %d\n",
                m->from_address, m->to_address, m->type, m->bytes, m->sent, m->asked, m->granted, m->entered,
                m->moved, m->freed, m->left, m->complete, m->taken, m->sending, m->taking);
        for (const struct trace_block *b = t->blocks + m->first_block;
             b < t->blocks + m->first_block + m->blocks; b++)
            fprintf(f, "  block %u %" PRIu64 " %" PRIu64 "\n", b->channel, b->begin, b->end);
    }
}

static void print(const struct trace *t, FILE *f)
{
    fprintf(f, "end %" PRIu64 " digest %016" PRIx64 "\n", t->end, t->digest);
    for (int32_t i = 0; i < t->node_count; i++)
        fprintf(f, "%s ends %" PRIu64 "\n", t->nodes[i].name, t->nodes[i].end);
    print_calls(t, f);
    for (const struct trace_handler *h = t->handlers; h < t->handlers + t->handler_count; h++)
        fprintf(f,
                "handler node %d type %d %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64
                " message %d%s\n",
                h->node, h->type, h->due, h->begin, h->entered, h->left, h->end, h->message,
                h->unfinished ? " unfinished" : "");
    for (const struct trace_system *s = t->systems; s < t->systems + t->system_count; s++)
        fprintf(f, "system node %d task %d %" PRIu64 " %" PRIu64 " %" PRIu64 "\n", s->node, s->task,
                s->charged, s->begin, s->end);
    print_messages(t, f);
}

char *trace_text(const char *path)
{
    char *text, *error = NULL;
    size_t size;
    if (access(path, R_OK) != 0)
        return strdup("");
    FILE *f = open_memstream(&text, &size);
    struct trace *t = trace_load(path, NULL, &error);
    if (t)
        print(t, f);
    else
        fprintf(f, "%s\n", error);
    free(error);
    trace_free(t);
    fclose(f);
    return text;
}
