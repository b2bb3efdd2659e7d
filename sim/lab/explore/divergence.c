/* divergence.c - see divergence.h. */
#include "lab/explore/divergence.h"
#include <inttypes.h>
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lab/explore/words_of.h"
#include "files/words.h"

static void earlier(struct divergence *best, struct divergence d)
{
    if (best->kind == DIVERGENCE_NONE || d.at < best->at ||
        (d.at == best->at && (d.node < best->node || (d.node == best->node && d.number < best->number))))
        *best = d;
}

static void compare_receives(struct divergence *best, const struct recording *base,
                             const struct recording *run)
{
    for (const struct rec_receive *v = run->receives; v < run->receives + run->receive_count; v++) {
        const struct rec_receive *b = recording_receive(base, v->node, v->number);
        if (b && (b->from != v->from || b->from_number != v->from_number))
            earlier(best, (struct divergence){DIVERGENCE_MESSAGE, v->node, v->number, v->at});
    }
}

static void compare_handlers(struct divergence *best, const struct recording *base,
                             const struct recording *run)
{
    for (const struct rec_handler *h = run->handlers; h < run->handlers + run->handler_count; h++) {
        const struct rec_handler *b = recording_handler(base, h->node, h->number);
        if (b && b->calls != h->calls)
            earlier(best, (struct divergence){DIVERGENCE_HANDLER, h->node, h->number, h->at});
    }
}

static vtime apart(vtime a, vtime b)
{
    return a > b ? a - b : b - a;
}

/* The handler whose time differs most. */
static void compare_moments(struct divergence *best, const struct recording *base,
                            const struct recording *run)
{
    vtime most = 0;
    for (const struct rec_handler *h = run->handlers; h < run->handlers + run->handler_count; h++) {
        const struct rec_handler *b = recording_handler(base, h->node, h->number);
        if (!b || b->at == VT_NEVER || h->at == VT_NEVER || apart(h->at, b->at) <= most)
            continue;
        most = apart(h->at, b->at);
        *best = (struct divergence){DIVERGENCE_MOMENT, h->node, h->number, h->at};
    }
}

/* Receives of one run that the other has not. */
static void compare_ends(struct divergence *best, const struct recording *has, const struct recording *lacks)
{
    for (const struct rec_receive *v = has->receives; v < has->receives + has->receive_count; v++)
        if (!recording_receive(lacks, v->node, v->number))
            earlier(best, (struct divergence){DIVERGENCE_MISSING, v->node, v->number, v->at});
}

struct divergence divergence_first(const struct recording *base, const struct recording *run)
{
    struct divergence best = {.kind = DIVERGENCE_NONE};
    compare_receives(&best, base, run);
    compare_handlers(&best, base, run);
    if (best.kind == DIVERGENCE_NONE)
        compare_moments(&best, base, run);
    if (best.kind == DIVERGENCE_NONE) {
        compare_ends(&best, base, run);
        compare_ends(&best, run, base);
    }
    return best;
}

/* --- words ---------------------------------------------------------------------------------------------- */

static void append_message(char **text, const struct recording *r, const struct rec_receive *v)
{
    char name[REC_NAME], to[REC_NAME], count[REC_ORDINAL], time[REC_TIME];
    const struct rec_message *m = &r->messages[v->message];
    words_append(text, "the %s message of %s to %s (type %" PRId64, rec_ordinal(m->number, count),
                 rec_node_name(m->from, r->nodes, name), rec_node_name(m->to, r->nodes, to), m->type);
    if (m->sent != VT_NEVER)
        words_append(text, ", sent at %s", rec_time(m->sent, time));
    words_append(text, "%s%s)", m->line ? ", " : "", m->line ? m->line : "");
}

static void append_place(char **text, const char *call, const char *line)
{
    if (call || line)
        words_append(text, " (%s%s%s)", call ? call : "", call && line ? ", " : "", line ? line : "");
}

static char *words_of_message(const struct divergence *d, const struct recording *base,
                              const struct recording *run)
{
    char name[REC_NAME], count[REC_ORDINAL], time[REC_TIME], *text;
    const struct rec_receive *v = recording_receive(run, d->node, d->number),
                             *b = recording_receive(base, d->node, d->number);
    text = xasprintf("at %s the %s receive of %s", rec_time(d->at, time), rec_ordinal(d->number, count),
                     rec_node_name(d->node, run->nodes, name));
    append_place(&text, v->call, v->line);
    words_append(&text, " got ");
    append_message(&text, run, v);
    words_append(&text, "; in the usual timing it got ");
    append_message(&text, base, b);
    return text;
}

/* Adds "in or after the program's 6th call". */
static void append_calls(char **text, uint64_t begun)
{
    char count[REC_ORDINAL];
    if (begun)
        words_append(text, "in or after the program's %s call", rec_ordinal(begun - 1, count));
    else
        words_append(text, "before the program's first call");
}

static char *words_of_handler(const struct divergence *d, const struct recording *base,
                              const struct recording *run)
{
    char name[REC_NAME], count[REC_ORDINAL], time[REC_TIME], *text;
    const struct rec_handler *h = recording_handler(run, d->node, d->number),
                             *b = recording_handler(base, d->node, d->number);
    text = xasprintf("at %s the %s handler of %s", rec_time(d->at, time), rec_ordinal(d->number, count),
                     rec_node_name(d->node, run->nodes, name));
    append_place(&text, NULL, h->line);
    words_append(&text, " ran ");
    append_calls(&text, h->calls);
    words_append(&text, "; in the usual timing ");
    append_calls(&text, b->calls);
    return text;
}

static char *words_of_moment(const struct divergence *d, const struct recording *base,
                             const struct recording *run)
{
    char name[REC_NAME], count[REC_ORDINAL], time[REC_TIME], *text;
    const struct rec_handler *h = recording_handler(run, d->node, d->number),
                             *b = recording_handler(base, d->node, d->number);
    text = xasprintf("after the same call, but at another moment: the %s handler of %s ran at %s",
                     rec_ordinal(d->number, count), rec_node_name(d->node, run->nodes, name),
                     rec_time(h->at, time));
    append_place(&text, NULL, h->line);
    words_append(&text, "; in the usual timing at %s", rec_time(b->at, time));
    append_place(&text, NULL, b->line);
    return text;
}

static char *words_of_missing(const struct divergence *d, const struct recording *base,
                              const struct recording *run)
{
    char name[REC_NAME], count[REC_ORDINAL], time[REC_TIME], *text;
    const struct rec_receive *in_base = recording_receive(base, d->node, d->number);
    const struct rec_receive *v = in_base ? in_base : recording_receive(run, d->node, d->number);
    text = xasprintf("every receive got the same message; but the %s receive of %s",
                     rec_ordinal(d->number, count), rec_node_name(d->node, run->nodes, name));
    append_place(&text, v->call, v->line);
    words_append(&text, " got its message only %s, at %s", in_base ? "in the usual timing" : "here",
                 rec_time(d->at, time));
    return text;
}

char *divergence_words(const struct divergence *d, const struct recording *base, const struct recording *run)
{
    switch (d->kind) {
    case DIVERGENCE_MESSAGE:
        return words_of_message(d, base, run);
    case DIVERGENCE_HANDLER:
        return words_of_handler(d, base, run);
    case DIVERGENCE_MOMENT:
        return words_of_moment(d, base, run);
    case DIVERGENCE_MISSING:
        return words_of_missing(d, base, run);
    default:
        return xstrdup(
            "no receive got another message, and no handler ran elsewhere: the program sees times, "
            "polls, or has a race between a handler and what it interrupts");
    }
}
