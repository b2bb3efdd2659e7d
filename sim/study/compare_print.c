/* compare_print.c - comparisons for people; see compare_print.h. */
#include "study/compare_print.h"

#include <math.h>
#include <string.h>

enum { MOST_MOVES = 5 }; /* of a kind */

static const char *verdict_word(enum compare_verdict v)
{
    static const char *const words[] = {"same", "differs", "better", "new", "WORSE", "MISSING", "FAILED"};
    return words[v];
}

/* --- figures --------------------------------------------------------------------------------------------- */

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

static void print_change(const struct compare_figure *f, FILE *out)
{
    print_value(f->before, out);
    fputs(" -> ", out);
    print_value(f->after, out);
    if (!isnan(f->change_pct))
        fprintf(out, " (%+.2f %%, %+.6g)", f->change_pct, f->change);
    else if (!isnan(f->change))
        fprintf(out, " (%+.6g)", f->change);
}

static void print_figures(const struct compare_point *p, FILE *out)
{
    static const char *const said[] = {
        [COMPARE_TOLD] = "", [COMPARE_BETTER] = "better", [COMPARE_WORSE] = "worse"};
    for (size_t i = 0; i < p->figure_count; i++) {
        const struct compare_figure *f = &p->figures[i];
        fprintf(out, "  %-6s  %-20s ", said[f->verdict], f->name);
        print_change(f, out);
        fputc('\n', out);
    }
}

/* --- where the time moved -------------------------------------------------------------------------------- */

/* Hosts are what the program's own nodes with handlers are in most programs; the words are those of a profile. */
static const char *class_word(const char *class)
{
    return strcmp(class, "with_handlers") == 0 ? "handlers" : class;
}

static void print_move(const struct compare_move *m, FILE *out)
{
    static const char *const kinds[] = {"", "system: ", "idle: ", ""};
    double change = m->after_s - m->before_s;
    fprintf(out, "    %-9s %s%s %+.6f s", class_word(m->class), kinds[m->kind], m->name, change);
    if (m->before_s != 0)
        fprintf(out, " (%+.1f %%)", 100 * change / fabs(m->before_s));
    else
        fputs(" (was not there)", out);
    fputc('\n', out);
}

static void print_kind(const struct compare_point *p, size_t from, size_t to, FILE *out)
{
    double rest = 0;
    for (size_t i = from; i < to; i++) {
        if (i - from < MOST_MOVES)
            print_move(&p->moves[i], out);
        else
            rest += p->moves[i].after_s - p->moves[i].before_s;
    }
    if (to - from > MOST_MOVES)
        fprintf(out, "    %zu more, %+.6f s\n", to - from - MOST_MOVES, rest);
}

/* Functions come first: they are the cause where anything is, and waits follow from them. */
static void print_moves(const struct compare_point *p, FILE *out)
{
    size_t from = 0;
    if (!p->move_count)
        return;
    fputs("  where the time of all nodes of a class moved:\n", out);
    for (size_t to = 1; to <= p->move_count; to++)
        if (to == p->move_count || p->moves[to].kind != p->moves[from].kind) {
            print_kind(p, from, to, out);
            from = to;
        }
}

/* --- a point --------------------------------------------------------------------------------------------- */

static void print_head(const struct compare_point *p, FILE *out)
{
    fprintf(out, "%-8s%s: %s", verdict_word(p->verdict), p->study, p->name);
}

void compare_print(const struct compare_point *p, FILE *out)
{
    if (p->verdict == COMPARE_SAME)
        return;
    print_head(p, out);
    if (p->failure)
        fprintf(out, ": %s", p->failure);
    else if (!p->after)
        fputs(": in the baseline, but not in the study", out);
    else if (!p->before)
        fputs(": not in the baseline", out);
    fputc('\n', out);
    print_figures(p, out);
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
