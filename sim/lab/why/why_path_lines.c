/* why_path_lines.c - see why_path_lines.h. */
#include "lab/why/why_path_lines.h"
#include <inttypes.h>
#include "lab/why/why_unit.h"

/* The message: "type 6, 4096 bytes, node 0 -> node 5". */
static void say_message(struct why *w, int32_t message, FILE *f)
{
    const struct trace_message *m = &w->t->messages[message];
    fprintf(f, "  type %" PRId32 ", %" PRIu64 " bytes, %s -> %s", m->type, m->bytes,
            m->from == TRACE_NONE ? "service" : why_node_name(w, m->from),
            m->to == TRACE_NONE ? "service" : why_node_name(w, m->to));
}

static void say_block(struct why *w, int32_t block, FILE *f)
{
    char channel[80];
    int32_t holder = w->holder[block];
    fprintf(f, ", at %s", trace_channel_name(w->t, w->t->blocks[block].channel, channel, sizeof channel));
    if (holder == TRACE_NONE)
        return;
    fputs(", held by", f);
    say_message(w, holder, f);
}

static void say_handler(struct why *w, int32_t handler, FILE *f)
{
    const struct trace_handler *h = &w->t->handlers[handler];
    int32_t type = h->message == TRACE_NONE ? h->type : w->t->messages[h->message].type;
    fprintf(f, "  handler of type %" PRId32 ", due at %.12f s", type, vt_seconds(h->due));
}

/* Where in the program. */
static void say_place(struct why *w, const struct path_step *s, FILE *f)
{
    const char *line = places_line(w->places, s->stack);
    bool towards = s->class == WHY_COMPUTING || (s->class == WHY_HANDLERS && s->call == TRACE_NONE);
    if (s->handler != TRACE_NONE)
        say_handler(w, s->handler, f);
    if (s->enters_handler)
        fprintf(f, "  into it, or out of it");
    else if (s->call != TRACE_NONE)
        fprintf(f, "  %s", places_call(w->places, s->call));
    else if (towards && *line)
        fprintf(f, "  up to %s", line);
}

static void line(struct why *w, const struct path_step *s, FILE *f)
{
    fprintf(f, "%18.12f %18.12f %16.12f  %-10s %-27s", vt_seconds(s->begin), vt_seconds(s->end),
            vt_seconds(s->end - s->begin), why_node_name(w, s->node), why_class_name(s->class));
    if (s->message != TRACE_NONE)
        say_message(w, s->message, f);
    else
        say_place(w, s, f);
    if (s->block != TRACE_NONE)
        say_block(w, s->block, f);
    fputc('\n', f);
}

void why_path_lines(struct why *w, FILE *f)
{
    fprintf(f, "%18s %18s %16s  %-10s %s\n", "from, s", "to, s", "for, s", "where", "what");
    for (size_t i = 0; i < w->path.count; i++)
        line(w, &w->path.steps[i], f);
}
