/* why_report.c - see why_report.h: sentences and tables. */
#include "lab/why/why_report.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "files/ink.h"
#include "files/number.h"
#include "kernel/xalloc.h"
#include "files/words.h"
#include "lab/why/path_shares.h"
#include "lab/why/why_sentences.h"
#include "lab/why/why_unit.h"
#include "nx_api/waitfor/waitfor_mpi.h"

enum { WIDTH = 100 };

/* The length of the text's first word; with its unit, if it is a number: "74.7 %)". */
static size_t word_at(const char *text)
{
    size_t word = strcspn(text, " "), unit = text[word] ? strspn(text + word + 1, "%munps") : 0;
    bool is_unit = unit && strchr(" ),.;:", text[word + 1 + unit]);
    if (word && text[word - 1] >= '0' && text[word - 1] <= '9' && is_unit)
        word += 1 + strcspn(text + word + 1, " ");
    return word;
}

/* Writes a paragraph with line breaks between words. */
static void paragraph(const char *text, FILE *f)
{
    size_t column = 0;
    while (*text) {
        size_t word = word_at(text);
        if (column && column + 1 + word > WIDTH) {
            fputc('\n', f);
            column = 0;
        }
        column += (size_t)fprintf(f, "%s%.*s", column ? " " : "", (int)word, text);
        text += word + (text[word] == ' ');
    }
    fputs("\n\n", f);
}

static size_t rows(const struct why_report_options *o, size_t count)
{
    return o->top && o->top < count ? o->top : count;
}

static void more(size_t shown, size_t count, FILE *f)
{
    if (shown < count)
        fprintf(f, "  ... and %zu more: --top %zu shows them\n", count - shown, count);
}

/* --- the path --- */

/* A part of the path, and what would be without. */
static void class_row(const struct why *w, const char *name, vtime_sum part, FILE *f)
{
    struct why_unit u = why_unit_for(w->length);
    vtime_sum left = w->length - part;
    fprintf(f, "  %-28s %12s %7.2f     at least %9s   at most %5s\n", name, why_number(u, part).text,
            100 * (double)part / (double)w->length, why_number(u, left).text,
            why_faster(w->length, left).text);
}

static void classes(struct why *w, FILE *f)
{
    struct why_unit u = why_unit_for(w->length);
    bool said[WHY_CLASSES] = {false};
    struct ink ink = ink_for(f);
    char *title = xasprintf("Critical path, %s step%s", number_grouped(w->path.count).text,
                            w->path.count == 1 ? "" : "s");
    fprintf(f, "%s%-30s %12s %7s %22s %15s%s\n", ink.bold, title, u.name, "%", "if it took no time",
            "times faster", ink.off);
    free(title);
    for (int most; (most = tally_longest(w->by_class, WHY_CLASSES, said)) >= 0;) {
        class_row(w, why_class_name((enum why_class)most), w->by_class[most], f);
        if (most == WHY_HANDLERS && w->entering)
            class_row(w, "  of it into and out of them", w->entering, f);
    }
}

/* The width of a table's first column. */
static int label_width(const struct tally *t, size_t shown)
{
    size_t width = 38;
    for (size_t i = 0; i < shown; i++)
        if (strlen(t->rows[i].label) > width)
            width = strlen(t->rows[i].label);
    return (int)width;
}

static void shares(struct why *w, enum why_share s, const struct why_report_options *o, FILE *f)
{
    const struct tally *t = &w->shares[s];
    struct why_unit u = why_unit_for(w->length);
    size_t shown = rows(o, t->count);
    if (!t->count)
        return;
    struct ink ink = ink_for(f);
    int width = label_width(t, shown);
    fprintf(f, "\n%sOf the path, by %-*s %10s %7s %9s%s\n", ink.bold, width - 14, why_share_title(s), u.name,
            "%", "steps", ink.off);
    for (size_t i = 0; i < shown; i++)
        fprintf(f, "  %-*s %10s %7.2f %9" PRIu64 "\n", width, t->rows[i].label,
                why_number(u, t->rows[i].time).text, 100 * (double)t->rows[i].time / (double)w->length,
                t->rows[i].count);
    more(shown, t->count, f);
}

/* --- waits --- */

static void causes(struct why *w, FILE *f)
{
    struct why_unit u = why_unit_for(w->causes.idle);
    struct ink ink = ink_for(f);
    fprintf(f, "\n%sWaits of %s nodes, by cause %*s %7s%s\n", ink.bold, w->some_nodes ? "some" : "all",
            w->some_nodes ? 10 : 11, u.name, "%", ink.off);
    bool said[WAIT_CAUSES] = {false};
    for (int most; (most = tally_longest(w->causes.by_cause, WAIT_CAUSES, said)) >= 0;)
        fprintf(f, "  %-24s %13s %7.2f\n", wait_cause_name((enum wait_cause)most),
                why_number(u, w->causes.by_cause[most]).text,
                100 * (double)w->causes.by_cause[most] / (double)w->causes.idle);
    fprintf(f, "  %-24s %13s %7.2f\n", "all idle time", why_number(u, w->causes.idle).text,
            w->causes.idle ? 100.0 : 0);
}

static const char *type_of(const struct wait_group *g)
{
    return waitfor_is_mpi(g->pid) ? waitfor_mpi_type(g->pid) : "type";
}

/* What a group's waits were for: "type 6 of node 0, from isend at a.c:3 (f)". */
static void group_partner(struct why *w, const struct wait_group *g, FILE *f)
{
    const char *partner = g->partners                ? "several nodes"
                          : g->partner == TRACE_NONE ? "a service"
                                                     : why_node_name(w, g->partner);
    if (g->cause == WAIT_DISK)
        return;
    if (g->leaves)
        fprintf(f, ", for messages to %s to leave", partner);
    else if (g->has_type && g->type == g->last_type)
        fprintf(f, ", for %s %" PRId32 " of %s", type_of(g), g->type, partner);
    else if (g->has_type)
        fprintf(f, ", for %ss %" PRId32 " to %" PRId32 " of %s", type_of(g), g->type, g->last_type, partner);
    if (*g->sent)
        fprintf(f, ", from %s", g->sent);
}

static void group_block(struct why *w, const struct wait_group *g, FILE *f)
{
    char channel[80];
    int32_t holder = w->holder[g->block];
    fprintf(f, "\n      longest at the channel %s",
            trace_channel_name(w->t, w->t->blocks[g->block].channel, channel, sizeof channel));
    if (holder != TRACE_NONE)
        fprintf(f, ", held by type %" PRId32 " from %s to %s", w->t->messages[holder].type,
                why_node_name(w, w->t->messages[holder].from), why_node_name(w, w->t->messages[holder].to));
}

static void group_for(struct why *w, const struct wait_group *g, FILE *f)
{
    struct why_unit u = why_unit_for(w->length);
    const struct trace_wait *longest = &w->t->waits[g->longest];
    if (g->cause == WAIT_LATE_SENDER || g->cause == WAIT_LATE_RECEIVER)
        fprintf(f, " (partner %s)",
                g->doing == TRACE_WAITING ? "waiting itself" : trace_state_name(g->doing));
    fprintf(f, "\n      in %s", g->call);
    group_partner(w, g, f);
    fprintf(f, "\n      longest %s, on %s, from %s on",
            why_time(why_unit_for(g->longest_idle), g->longest_idle).text, why_node_name(w, longest->node),
            why_time(u, longest->begin).text);
    if (g->block != TRACE_NONE)
        group_block(w, g, f);
}

static void groups(struct why *w, const struct why_report_options *o, FILE *f)
{
    struct why_unit u = why_unit_for(w->causes.idle);
    size_t shown = rows(o, w->group_count);
    struct ink ink = ink_for(f);
    fprintf(f, "\n%sThe longest waits, alike ones together%s\n%12s %7s %9s %6s\n", ink.bold, ink.off, u.name,
            "%", "waits", "nodes");
    for (size_t i = 0; i < shown; i++) {
        const struct wait_group *g = &w->groups[i];
        fprintf(f, "%12s %7.2f %9" PRIu64 " %6" PRId32 "  %s", why_number(u, g->idle).text,
                100 * (double)g->idle / (double)w->causes.idle, g->waits, g->nodes,
                wait_cause_name(g->cause));
        group_for(w, g, f);
        fputc('\n', f);
    }
    more(shown, w->group_count, f);
}

/* --- other runs --- */

static void show_rerun(struct why_unit u, const struct rerun *x, vtime before, FILE *f)
{
    struct why_text now = why_time(u, x->end), then = why_time(u, before);
    if (!x->done)
        fprintf(f, "  no answer %s: %s\n", x->what, x->error);
    else if (!strcmp(now.text, then.text))
        fprintf(f, "  would still take %s %s\n", now.text, x->what);
    else
        fprintf(f, "  would take %s instead of %s (%s times %s) %s\n", now.text, then.text,
                (x->end < before ? why_faster(before, x->end) : why_faster(x->end, before)).text,
                x->end < before ? "faster" : "slower", x->what);
}

/* The first is the run as it was, and takes the time of the trace. */
static void show_reruns(struct why *w, const struct reruns *r, FILE *f)
{
    struct why_unit u = why_unit_for(w->t->end);
    fprintf(f, "Run again with numbers of the machine changed, the program\n");
    for (size_t i = 1; i < r->count; i++)
        show_rerun(u, &r->list[i], w->t->end, f);
}

/* The class of which this run's path has most more than the other's. */
static enum why_class grown(const struct why *w, const struct why *than)
{
    int most = 0;
    for (int i = 1; i < WHY_CLASSES; i++)
        if (w->by_class[i] - than->by_class[i] > w->by_class[most] - than->by_class[most])
            most = i;
    return (enum why_class)most;
}

/* How the other run differs, in a sentence, in the unit of the table below it. */
static void say_difference(struct why *w, struct why *than, struct why_unit u, FILE *f)
{
    enum why_class most = grown(w, than);
    vtime_sum grown_to = w->by_class[most], grown_from = than->by_class[most];
    bool longer = w->length > than->length;
    const int32_t nodes = trace_nodes_ran(than->t);
    char *text = xasprintf("The run of %s, on %" PRId32 " node%s%s, took %s. This one took ", than->t->path,
                           nodes, nodes == 1 ? "" : "s", than->t->topo.host ? " and the host" : "",
                           why_time(u, than->length).text);
    if (w->length == than->length)
        words_append(&text, "as long.");
    else
        words_append(&text, "%s %s.",
                     why_time(u, longer ? w->length - than->length : than->length - w->length).text,
                     longer ? "more" : "less");
    if (longer && grown_to > grown_from)
        words_append(&text, " On the critical path, %s grew most: by %s, from %s to %s.",
                     why_class_subject(most), why_time(u, grown_to - grown_from).text,
                     why_time(u, grown_from).text, why_time(u, grown_to).text);
    paragraph(text, f);
    free(text);
}

static void compare_row(struct why_unit u, const char *name, vtime_sum this_run, vtime_sum other, FILE *f)
{
    bool more = this_run >= other;
    struct why_text by = why_number(u, more ? this_run - other : other - this_run);
    bool none = !strcmp(by.text, why_number(u, 0).text);
    char *difference = xasprintf("%s%s", none ? "" : more ? "+" : "-", by.text);
    fprintf(f, "  %-28s %14s %14s %14s\n", name, why_number(u, this_run).text, why_number(u, other).text,
            difference);
    free(difference);
}

/* The other run's path beside this one's. */
static void compare(struct why *w, struct why *than, FILE *f)
{
    struct why_unit u = why_unit_for(w->length > than->length ? w->length : than->length);
    say_difference(w, than, u, f);
    struct ink ink = ink_for(f);
    char *title = xasprintf("Critical path, %s", u.name);
    fprintf(f, "%s%-30s %14s %14s %14s%s\n", ink.bold, title, "this run", "the other", "more", ink.off);
    free(title);
    for (int i = 0; i < WHY_CLASSES; i++)
        if (w->by_class[i] || than->by_class[i])
            compare_row(u, why_class_name((enum why_class)i), w->by_class[i], than->by_class[i], f);
    compare_row(u, "all", w->length, than->length, f);
}

void why_report(struct why *w, const struct why_report_options *o, FILE *f)
{
    char **paragraphs = why_sentences(w);
    for (char **p = paragraphs; *p; p++)
        paragraph(*p, f);
    why_sentences_free(paragraphs);
    if (o->than)
        compare(w, o->than, f), fputc('\n', f);
    if (o->reruns)
        show_reruns(w, o->reruns, f), fputc('\n', f);
    classes(w, f);
    for (int s = 0; s < WHY_SHARES; s++)
        shares(w, (enum why_share)s, o, f);
    causes(w, f);
    if (w->group_count)
        groups(w, o, f);
}
