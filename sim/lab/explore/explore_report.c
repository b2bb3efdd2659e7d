/* explore_report.c - see explore_report.h. */
#include "lab/explore/explore_report.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "files/ink.h"
#include "files/virtual_time.h"
#include "kernel/xalloc.h"
#include "lab/explore/guarantee.h"
#include "lab/jobs/line_changes.h"

enum { MOST_LINES = 8, MOST_DELAYS = 10 };

static const char *text_of(const json_t *record, const char *key)
{
    const char *text = json_string_value(json_object_get(record, key));
    return text ? text : "";
}

static const char *plural(size_t count)
{
    return count == 1 ? "" : "s";
}

char *explore_repeat(const struct explore *x, const struct explored *run)
{
    char *file = run->schedule ? batch_recording(&x->place, run->key) : NULL;
    char *command = explore_command(x, run->outcome, run->timing, file);
    free(file);
    return command;
}

/* --- the runs ------------------------------------------------------------------------------------------- */

static void print_bounds(const struct explore *x, FILE *out)
{
    const struct draw *d = &x->options.draw;
    fprintf(out,
            "  bounds     messages leave up to %s later, handlers become due %s later, programs start %s\n"
            "             later, nodes compute %.4g %% slower\n",
            limit_text(vt_seconds(d->messages)).text, limit_text(vt_seconds(d->interrupts)).text,
            limit_text(vt_seconds(d->start)).text, d->speed_ppm / 1e4);
}

static void print_kinds(const struct search *s, FILE *out)
{
    size_t pct = s->seeds / 2;
    fprintf(out, "  runs       the usual timing; %zu random, %zu in the manner of PCT, %zu directed\n",
            s->seeds - pct, pct, s->directed);
    fprintf(
        out,
        "  orders     %zu different; not tried: %zu that begin like an earlier run, %zu beyond the bounds, "
        "%zu for lack of runs\n",
        s->orders.count, s->pruned, s->out_of_bounds, s->flip_count);
}

/* How many runs of that depth were made: seeds go round (search.c). */
static size_t made_of_depth(const struct search *s, uint32_t depth)
{
    size_t pct = s->seeds / 2;
    return pct / s->draw.depth + (pct % s->draw.depth >= depth);
}

static void print_depth(const struct search *s, double runs, uint32_t depth, FILE *out)
{
    fprintf(out, "\n             depth %" PRIu32 " in at most %.0f run%s of that depth; %zu made", depth,
            runs, runs == 1 ? "" : "s", made_of_depth(s, depth));
}

static void print_guarantee(const struct explore *x, FILE *out)
{
    const struct search *s = &x->search;
    uint64_t events = (uint64_t)json_integer_value(json_object_get(s->outcomes[0].record, "events"));
    fprintf(out,
            "  guarantee  PCT, if these bounds allow every order, finds with 95 %% probability a fault of");
    for (uint32_t depth = 1; depth <= s->draw.depth && depth <= 3; depth++)
        print_depth(s, guarantee_runs(s->programs, events, depth), depth, out);
    fprintf(out, "\n             (%" PRIu32 " program%s, %" PRIu64 " message%s and handlers)\n", s->programs,
            s->programs == 1 ? "" : "s", events, events == 1 ? "" : "s");
}

/* --- an outcome ----------------------------------------------------------------------------------------- */

static void print_indented(const char *text, size_t lines, FILE *out)
{
    for (size_t i = 0; i < lines && *text; i++) {
        size_t length = strcspn(text, "\n");
        fprintf(out, "       %.*s\n", (int)length, text);
        text += length + (text[length] == '\n');
    }
    if (*text)
        fprintf(out, "       ...\n");
}

/* Why a run did not end, and what its program said of that. */
static void print_failure(const json_t *record, FILE *out)
{
    print_indented(text_of(record, "message"), MOST_LINES, out);
    if (json_object_get(record, "stderr")) {
        fprintf(out, "     its standard error ended with\n");
        print_indented(text_of(record, "stderr"), MOST_LINES, out);
    }
}

static void print_delays(const struct explore *x, const struct explained *e, FILE *out)
{
    const struct delays *d = &e->least.delays;
    fprintf(out, "     %s, %zu delay%s, found by %zu runs, in %s/%s.schedule:\n",
            e->least.is_least ? "the fewest delays that show it" : "delays that show it", d->count,
            plural(d->count), e->least.tests, x->options.dir, e->name);
    for (size_t i = 0; i < d->count && i < MOST_DELAYS; i++) {
        char *words = delay_words(&d->list[i], x->search.base_nodes);
        fprintf(out, "       %s\n", words);
        free(words);
    }
    if (d->count > MOST_DELAYS)
        fprintf(out, "       ...\n");
    char *file = xasprintf("%s/%s.schedule", x->options.dir, e->name);
    char *command = explore_command(x, (size_t)(e - x->explained), NULL, file);
    fprintf(out, "       %s\n", command);
    free(command);
    free(file);
}

static void print_explained(const struct explore *x, const struct explained *e, FILE *out)
{
    if (!e->name)
        return;
    if (e->least.repeats)
        print_delays(x, e, out);
    else
        fprintf(out, "     its delays alone do not repeat it: use the command above\n");
    if (e->first)
        fprintf(out, "     first difference: %s\n", e->first);
}

static void print_change(const struct explore *x, size_t outcome, FILE *out)
{
    const json_t *base = x->search.outcomes[0].record, *other = x->search.outcomes[outcome].record;
    if (json_object_get(other, "message")) {
        print_failure(other, out);
        return;
    }
    char *change = line_changes(text_of(base, "shown"), text_of(other, "shown"));
    print_indented(change, MOST_LINES, out);
    free(change);
}

static const char *name_of_end(const json_t *record)
{
    const char *end = text_of(record, "end");
    return strcmp(end, "ended") ? end : "another output";
}

static void print_outcome(const struct explore *x, size_t outcome, FILE *out)
{
    const struct outcome_group *g = &x->search.outcomes[outcome];
    const struct explored *run = &x->search.runs[g->first];
    char *command = explore_repeat(x, run);
    struct ink ink = ink_for(out);
    fprintf(out, "\n  %s%zu. %s:%s %zu run%s, first %s\n", ink.bold, outcome, name_of_end(g->record), ink.off,
            g->runs, plural(g->runs), run->name);
    print_change(x, outcome, out);
    fprintf(out, "     to repeat the first:\n       %s\n", command);
    print_explained(x, &x->explained[outcome], out);
    free(command);
}

/* --- all ------------------------------------------------------------------------------------------------ */

static void print_usual(const struct search *s, FILE *out)
{
    const struct outcome_group *base = &s->outcomes[0];
    fprintf(out, "  usual      %s; the same in %zu of %zu runs\n", text_of(base->record, "end"), base->runs,
            s->run_count);
    if (base->reordered)
        fprintf(out,
                "             (in %zu of them in another order of lines: --ordered compares that, too)\n",
                base->reordered);
    print_failure(base->record, out);
}

static void print_summary(const struct explore *x, FILE *out)
{
    const struct search *s = &x->search;
    const struct subject_options *o = &x->subject->options;
    fprintf(out, "%s: %zu run%s, %zu order%s: ", o->host ? o->host : o->program[0], s->run_count,
            plural(s->run_count), s->orders.count, plural(s->orders.count));
    bool fails = !explore_usual_ended(x);
    if (s->outcome_count == 1)
        fprintf(out, "%s\n",
                fails                      ? "all fail, with the usual timing, too"
                : s->outcomes[0].reordered ? "all the same, but for the order of lines"
                                           : "all the same");
    else
        fprintf(out, "%zu outcome%s differ%s from that of the usual timing%s\n", s->outcome_count - 1,
                plural(s->outcome_count - 1), s->outcome_count == 2 ? "s" : "", fails ? ", which fails" : "");
    print_usual(s, out);
}

static void print_warnings(const struct explore *x, FILE *out)
{
    const struct search *s = &x->search;
    if (s->failed)
        fprintf(out, "  %zu run%s did not end within %s of real time, and do%s not count\n", s->failed,
                plural(s->failed), limit_text(x->options.limit_s).text, s->failed == 1 ? "es" : "");
    if (x->out_of_time)
        fprintf(out, "  Time is up: not all runs were made.\n");
}

/* Of outcomes that differ in output only, of one order, the first is shown; of others, those explained. */
static void print_outcomes(const struct explore *x, FILE *out)
{
    size_t alike = 0, left = 0;
    for (size_t i = 1; i < x->search.outcome_count; i++) {
        bool same = x->search.outcomes[i].same_order;
        alike += same;
        if (same ? alike == 1 : i <= x->options.explained)
            print_outcome(x, i, out);
        left += !same && i > x->options.explained;
    }
    if (left)
        fprintf(out, "\n  and %zu more outcome%s: --json FILE has all\n", left, plural(left));
    if (alike > 1)
        fprintf(
            out,
            "\n  and %zu more outcome%s whose runs had an order that another outcome had, too: they differ "
            "in output only\n",
            alike - 1, plural(alike - 1));
}

void explore_print(const struct explore *x, FILE *out)
{
    print_summary(x, out);
    if (x->search.times_differ)
        fprintf(out, "  %s\n", EXPLORE_TIMES_HINT);
    print_kinds(&x->search, out);
    print_bounds(x, out);
    print_guarantee(x, out);
    print_warnings(x, out);
    print_outcomes(x, out);
    if (!x->made)
        fprintf(out, "\n  no run made: all %zu were in %s/journal\n", x->before, x->options.dir);
    else
        fprintf(out, "\n  %zu runs made in %s, %.1f a second, %u at a time; %zu were in %s/journal\n",
                x->made, duration_text(x->wall_s).text, x->wall_s > 0 ? (double)x->made / x->wall_s : 0,
                x->options.at_once, x->before, x->options.dir);
}
