/* compare.c - see compare.h. */
#include "lab/check/compare.h"
#include "kernel/xalloc.h"
#include "lab/jobs/outcome.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- a figure ------------------------------------------------------------------------------------------- */

/* 1 if more of the figure is worse, -1 if less is worse, 0 if neither. */
static int direction(const char *figure)
{
    static const char *const costs[] = {"total_s",  "time_s", "virtual_time_s",
                                        "messages", "bytes",  "memory_peak_bytes"};
    static const char *const speeds[] = {"speedup", "speed_per_node"};
    for (size_t i = 0; i < sizeof costs / sizeof *costs; i++)
        if (strcmp(figure, costs[i]) == 0)
            return 1;
    for (size_t i = 0; i < sizeof speeds / sizeof *speeds; i++)
        if (strcmp(figure, speeds[i]) == 0)
            return -1;
    return 0;
}

/* Did this speed change because the point's own time did? (It is relative to another point's time, too.) */
static bool is_own(const struct compare_figure *f, double longer)
{
    return isnan(longer) || f->change * longer < 0;
}

/* The last tolerance for the figure, or else the last general one; NULL if there is none. */
static const struct compare_tolerance *tolerance_of(const struct compare_rules *rules, const char *figure)
{
    const struct compare_tolerance *general = NULL, *own = NULL;
    for (size_t i = 0; i < rules->count; i++) {
        if (!rules->tolerances[i].figure)
            general = &rules->tolerances[i];
        else if (strcmp(rules->tolerances[i].figure, figure) == 0)
            own = &rules->tolerances[i];
    }
    return own ? own : general;
}

static bool is_within(const struct compare_figure *f, const struct compare_tolerance *t)
{
    return t && fabs(f->change) <= t->allowed * (t->relative ? fabs(json_number_value(f->before)) : 1);
}

/* longer: by how many seconds the run's time grew; NAN if not known. */
static enum compare_verdict judge(const struct compare_figure *f, double longer,
                                  const struct compare_rules *rules)
{
    const struct compare_tolerance *t = tolerance_of(rules, f->name);
    int worse = direction(f->name);
    if (rules->exact)
        return COMPARE_WORSE;
    if (!worse && !(t && t->figure))
        return COMPARE_TOLD;
    if (!f->before)
        return COMPARE_TOLD;
    if (isnan(f->change))
        return COMPARE_WORSE;
    if (is_within(f, t) || (worse < 0 && !(t && t->figure) && !is_own(f, longer)))
        return COMPARE_TOLD;
    return worse && f->change * worse < 0 ? COMPARE_BETTER : COMPARE_WORSE;
}

static struct compare_figure figure_of_both(const char *name, const json_t *before, const json_t *after)
{
    struct compare_figure f = {
        .name = name, .before = before, .after = after, .change = NAN, .change_pct = NAN};
    if (json_is_number(before) && json_is_number(after)) {
        f.change = json_number_value(after) - json_number_value(before);
        if (json_number_value(before) != 0)
            f.change_pct = 100 * f.change / fabs(json_number_value(before));
    }
    return f;
}

/* Sorts by gravity, then by size of the change. */
static int by_gravity(const void *a, const void *b)
{
    const struct compare_figure *x = a, *y = b;
    if (x->verdict != y->verdict)
        return x->verdict < y->verdict ? 1 : -1;
    double p = isnan(x->change_pct) ? -1 : fabs(x->change_pct),
           q = isnan(y->change_pct) ? -1 : fabs(y->change_pct);
    return p != q ? (p < q ? 1 : -1) : strcmp(x->name, y->name);
}

static void add_figure(struct compare_point *p, const char *name, double longer,
                       const struct compare_rules *rules)
{
    const json_t *before = json_object_get(json_object_get(p->before, "figures"), name);
    const json_t *after = json_object_get(json_object_get(p->after, "figures"), name);
    if ((before && after && json_equal(before, after)) || (rules->only && strcmp(rules->only, name) != 0))
        return;
    struct compare_figure f = figure_of_both(name, before, after);
    f.verdict = judge(&f, longer, rules);
    if (f.change == 0) /* 1 and 1.0 */
        return;
    p->figures = xrealloc(p->figures, (p->figure_count + 1) * sizeof *p->figures);
    p->figures[p->figure_count++] = f;
    if (f.verdict > p->verdict)
        p->verdict = f.verdict;
}

static void compare_figures(struct compare_point *p, const struct compare_rules *rules)
{
    json_t *before = json_object_get(p->before, "figures"), *after = json_object_get(p->after, "figures");
    const char *name;
    json_t *value;
    double longer = figure_of(after, "virtual_time_s") - figure_of(before, "virtual_time_s");
    json_object_foreach(before, name, value) add_figure(p, name, longer, rules);
    json_object_foreach(after, name, value) if (!json_object_get(before, name))
        add_figure(p, name, longer, rules);
    if (p->figure_count)
        qsort(p->figures, p->figure_count, sizeof *p->figures, by_gravity);
}

/* --- where the time moved ------------------------------------------------------------------------------- */

static int by_move(const void *a, const void *b)
{
    const struct compare_move *x = a, *y = b;
    if (x->kind != y->kind)
        return x->kind < y->kind ? -1 : 1;
    double p = fabs(x->after_s - x->before_s), q = fabs(y->after_s - y->before_s);
    return p != q ? (p < q ? 1 : -1) : strcmp(x->name, y->name);
}

static void add_move(struct compare_point *p, enum compare_kind kind, const char *class, const char *name,
                     const json_t *before, const json_t *after)
{
    struct compare_move move = {kind, class, name, json_number_value(before), json_number_value(after)};
    if (move.before_s == move.after_s)
        return;
    p->moves = xrealloc(p->moves, (p->move_count + 1) * sizeof *p->moves);
    p->moves[p->move_count++] = move;
}

static void compare_class(struct compare_point *p, const char *class, const json_t *before,
                          const json_t *after)
{
    static const char *const kinds[] = {"functions", "system", "idle"};
    for (int kind = 0; kind < COMPARE_ENDED; kind++) {
        json_t *old = json_object_get(before, kinds[kind]), *new = json_object_get(after, kinds[kind]),
               *value;
        const char *name;
        json_object_foreach(old, name, value)
            add_move(p, kind, class, name, value, json_object_get(new, name));
        json_object_foreach(new, name, value) if (!json_object_get(old, name))
            add_move(p, kind, class, name, NULL, value);
    }
    add_move(p, COMPARE_ENDED, class, "ended", json_object_get(before, "ended"),
             json_object_get(after, "ended"));
}

/* Was the program profiled? A profile names functions; without one there is only "all of the program". */
static bool is_profiled(const json_t *where)
{
    const char *class;
    json_t *value;
    bool unknown = false;
    json_object_foreach((json_t *)where, class, value) unknown |=
        json_object_get(json_object_get(value, "functions"), "all of the program") != NULL;
    return !unknown;
}

static void compare_where(struct compare_point *p)
{
    json_t *before = json_object_get(p->before, "where"), *after = json_object_get(p->after, "where"), *value;
    const char *class;
    if (!before || !after)
        return;
    if ((p->one_profiled = is_profiled(before) != is_profiled(after)))
        return;
    json_object_foreach(before, class, value) compare_class(p, class, value, json_object_get(after, class));
    json_object_foreach(after, class, value) if (!json_object_get(before, class))
        compare_class(p, class, NULL, value);
    if (p->move_count)
        qsort(p->moves, p->move_count, sizeof *p->moves, by_move);
}

/* --- a point -------------------------------------------------------------------------------------------- */

static void set_time(struct compare_point *p)
{
    double time = figure_of(json_object_get(p->after, "figures"), "virtual_time_s");
    p->time_s = isnan(time) ? 0 : time;
}

static void drop(struct compare_point *p)
{
    json_decref(p->before);
    json_decref(p->after);
    p->before = p->after = NULL;
}

struct compare_point *compare_point(const char *study, const char *name, json_t *before, json_t *after,
                                    const char *failure, const struct compare_rules *rules)
{
    struct compare_point *p = xcalloc(1, sizeof *p);
    p->study = xstrdup(study);
    p->name = xstrdup(name);
    p->before = json_incref(before);
    p->after = json_incref(after);
    if (failure) {
        p->failure = xstrdup(failure);
        p->verdict = COMPARE_FAILED;
    } else if (!after) {
        p->verdict = COMPARE_MISSING;
    } else if (!before) {
        p->verdict = COMPARE_NEW;
    } else {
        compare_figures(p, rules);
        if (p->verdict != COMPARE_SAME)
            compare_where(p);
    }
    set_time(p);
    if (p->verdict == COMPARE_SAME)
        drop(p);
    return p;
}

void compare_free(struct compare_point *p)
{
    if (!p)
        return;
    drop(p);
    free(p->figures);
    free(p->moves);
    free(p->study);
    free(p->name);
    free(p->failure);
    free(p);
}
