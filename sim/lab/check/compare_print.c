/* compare_print.c - see compare_print.h. */
#include "lab/check/compare_print.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_MOVES = 5 };               /* shown of each kind */
static const double LEAST_MOVE = 1e-3; /* shown, as a part of the largest of its kind */

static const char *verdict_word(enum compare_verdict v)
{
    static const char *const words[] = {"same", "differs", "better", "new", "WORSE", "MISSING", "FAILED"};
    return words[v];
}

/* --- figures -------------------------------------------------------------------------------------------- */

static void print_value(const json_t *value, FILE *out)
{
    if (json_is_integer(value))
        fprintf(out, "%" JSON_INTEGER_FORMAT, json_integer_value(value));
    else if (json_is_real(value))
        fprintf(out, "%.10g", json_real_value(value));
    else if (json_is_string(value))
        fputs(json_string_value(value), out);
    else if (!value)
        fputs("none", out);
    else
        for (size_t i = 0; i < json_array_size(value); i++) {
            fputs(i ? " " : "", out);
            print_value(json_array_get(value, i), out);
        }
}

static bool is_exact(double number, int decimals)
{
    char short_text[512], text[32];
    snprintf(short_text, sizeof short_text, "%.*f", decimals, number);
    snprintf(text, sizeof text, "%.12g", number);
    return strtod(short_text, NULL) == strtod(text, NULL);
}

static bool differ(double a, double b, int decimals)
{
    double unit = pow(10, -decimals);
    return round(a / unit) != round(b / unit);
}

/* With so many decimals the larger of two numbers has six digits; it has more where the two would not
 * differ, and fewer where both have fewer. */
static int decimals_of(double a, double b)
{
    double most = fmax(fabs(a), fabs(b));
    int six = most > 0 ? 5 - (int)floor(log10(most)) : 0, decimals = 0;
    while (decimals < 15 && !(is_exact(a, decimals) && is_exact(b, decimals)) &&
           !(decimals >= six && differ(a, b, decimals)))
        decimals++;
    return decimals;
}

static void print_change(const struct compare_figure *f, FILE *out)
{
    double before = json_number_value(f->before), after = json_number_value(f->after);
    bool numbers = json_is_number(f->before) && json_is_number(f->after);
    int decimals = numbers ? decimals_of(before, after) : 0;
    if (numbers) {
        fprintf(out, "%.*f -> %.*f", decimals, before, decimals, after);
    } else {
        print_value(f->before, out);
        fputs(" -> ", out);
        print_value(f->after, out);
    }
    if (isnan(f->change))
        return;
    fputs(" (", out);
    if (f->change_pct >= 1000)
        fprintf(out, "%.0f times as much, ", 1 + f->change_pct / 100);
    else if (!isnan(f->change_pct))
        fprintf(out, "%+.2f %%, ", f->change_pct);
    fprintf(out, "%+.*f)", decimals, f->change);
}

static void print_figures(const struct compare_point *p, FILE *out)
{
    static const char *const said[] = {
        [COMPARE_TOLD] = "", [COMPARE_BETTER] = "better", [COMPARE_WORSE] = "worse"};
    int widest = 20;
    for (size_t i = 0; i < p->figure_count; i++)
        widest = strlen(p->figures[i].name) > (size_t)widest ? (int)strlen(p->figures[i].name) : widest;
    for (size_t i = 0; i < p->figure_count; i++) {
        const struct compare_figure *f = &p->figures[i];
        fprintf(out, "  %-6s  %-*s ", said[f->verdict], widest, f->name);
        print_change(f, out);
        fputc('\n', out);
    }
}

/* --- where the time moved ------------------------------------------------------------------------------- */

/* Has the point one class of nodes only, as it has where no node has handlers? */
static bool is_one_class(const struct compare_point *p)
{
    return json_object_size(json_object_get(p->after, "where")) == 1;
}

/* The class's name in a profile's table; as in a run's summary, it is none if there is no other. */
static const char *class_word(const struct compare_point *p, const char *class)
{
    return is_one_class(p) ? "nodes" : strcmp(class, "with_handlers") == 0 ? "handlers" : class;
}

static double change_of(const struct compare_move *m)
{
    return m->after_s - m->before_s;
}

/* With so many decimals the point's largest change has four digits; at least as many as a run's figures in
 * seconds have, and at most those of a picosecond. */
static int decimals_of_moves(const struct compare_point *p)
{
    double most = 0;
    for (size_t i = 0; i < p->move_count; i++)
        most = fmax(most, fabs(change_of(&p->moves[i])));
    return most > 0 ? (int)fmin(fmax(3 - floor(log10(most)), 6), 12) : 6;
}

static void print_move(const struct compare_point *p, const struct compare_move *m, int decimals, FILE *out)
{
    static const char *const kinds[] = {"", "system: ", "idle: ", ""};
    fprintf(out, "    %-9s %s%s %+.*f s", class_word(p, m->class), kinds[m->kind], m->name, decimals,
            change_of(m));
    if (m->before_s != 0)
        fprintf(out, " (%+.1f %%)", 100 * change_of(m) / fabs(m->before_s));
    else
        fputs(" (was not there)", out);
    fputc('\n', out);
}

/* Prints the largest moves of a kind; the small ones as a sum. */
static void print_kind(const struct compare_point *p, size_t from, size_t to, int decimals, FILE *out)
{
    double rest = 0, least = LEAST_MOVE * fabs(change_of(&p->moves[from]));
    size_t shown = from;
    while (shown < to && shown - from < MOST_MOVES && fabs(change_of(&p->moves[shown])) >= least)
        print_move(p, &p->moves[shown++], decimals, out);
    for (size_t i = shown; i < to; i++)
        rest += change_of(&p->moves[i]);
    if (shown < to)
        fprintf(out, "    %zu more, %+.*f s\n", to - shown, decimals, rest);
}

/* Prints "others    in all: functions +1.000000 s, idle -0.500000 s". */
static void print_class(const struct compare_point *p, const char *class, int decimals, FILE *out)
{
    static const char *const kinds[COMPARE_KINDS] = {"functions", "system", "idle", "ended"};
    double sum[COMPARE_KINDS] = {0};
    const char *mark = "";
    for (size_t i = 0; i < p->move_count; i++)
        if (strcmp(p->moves[i].class, class) == 0)
            sum[p->moves[i].kind] += change_of(&p->moves[i]);
    fprintf(out, "    %-9s in all: ", class_word(p, class));
    for (int kind = 0; kind < COMPARE_KINDS; kind++)
        if (fabs(sum[kind]) >= 0.5 * pow(10, -decimals)) { /* what is less is rounding */
            fprintf(out, "%s%s %+.*f s", mark, kinds[kind], decimals, sum[kind]);
            mark = ", ";
        }
    fputs(*mark ? "\n" : "nothing\n", out);
}

/* Functions come first: other times usually change because of them. */
static void print_moves(const struct compare_point *p, FILE *out)
{
    const char *class;
    json_t *value;
    size_t from = 0;
    int decimals = decimals_of_moves(p);
    if (!p->move_count)
        return;
    fprintf(out, "  where the time of all nodes%s moved:\n", is_one_class(p) ? "" : " of a class");
    for (size_t to = 1; to <= p->move_count; to++)
        if (to == p->move_count || p->moves[to].kind != p->moves[from].kind) {
            print_kind(p, from, to, decimals, out);
            from = to;
        }
    json_object_foreach(json_object_get(p->after, "where"), class, value)
        print_class(p, class, decimals, out);
}

/* --- a point -------------------------------------------------------------------------------------------- */

static void print_head(const struct compare_point *p, FILE *out)
{
    fprintf(out, "%-8s%s: %s", verdict_word(p->verdict), p->study, p->name);
    if (p->failure)
        fprintf(out, ": %s", p->failure);
    else if (p->verdict == COMPARE_MISSING)
        fputs(": in the baseline, but not in the study", out);
    else if (p->verdict == COMPARE_NEW)
        fputs(": not in the baseline", out);
}

void compare_print(const struct compare_point *p, FILE *out)
{
    if (p->verdict == COMPARE_SAME)
        return;
    print_head(p, out);
    fputc('\n', out);
    print_figures(p, out);
    if (p->one_profiled)
        fputs("  where the time moved is not known: only one of the two has a profile\n", out);
    print_moves(p, out);
}

void compare_print_short(const struct compare_point *p, FILE *out)
{
    print_head(p, out);
    if (p->figure_count) {
        fprintf(out, ": %s ", p->figures[0].name);
        print_change(&p->figures[0], out);
        if (p->figure_count > 1)
            fprintf(out, ", and %zu more", p->figure_count - 1);
    }
    fputc('\n', out);
}
