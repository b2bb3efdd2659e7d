/* report.c - the results as a table on the terminal and as a page. */
#include "validate.h"
#include <math.h>
#include <string.h>

/* "72 to 77", "8", or "-" */
static const char *published(const struct figure *f, char text[64])
{
    if (f->open)
        strcpy(text, "-");
    else if (f->low == f->high)
        snprintf(text, 64, "%.5g", f->low);
    else
        snprintf(text, 64, "%.5g to %.5g", f->low, f->high);
    return text;
}

static const char *error_of(const struct figure *f, char text[32])
{
    snprintf(text, 32, f->open ? "" : "%+.1f %%", 100 * f->error);
    return text;
}

struct errors {
    unsigned count;
    double sum, worst;
};

static void add_error(struct errors *e, double error)
{
    e->count++;
    e->sum += fabs(error);
    e->worst = fabs(error) > fabs(e->worst) ? error : e->worst;
}

/* The last line: mean and worst error of what nothing was fitted to, and of the rest. */
static void print_errors(const struct plan *p, FILE *f)
{
    struct errors of[2] = {0}; /* fitted: of[1] */
    for (size_t i = 0; i < p->curve_count; i++)
        add_error(&of[p->curves[i].fitted], p->curves[i].worst);
    for (size_t i = 0; i < p->figure_count; i++)
        if (!p->figures[i].open)
            add_error(&of[p->figures[i].fitted], p->figures[i].error);
    fprintf(
        f,
        "\nErrors: of %u figures that nothing was fitted to, %.1f %% in the mean, %+.1f %% the worst; of %u "
        "that a number was chosen by, %.1f %% in the mean, %+.1f %% the worst.\n",
        of[0].count, of[0].count ? 100 * of[0].sum / of[0].count : 0, 100 * of[0].worst, of[1].count,
        of[1].count ? 100 * of[1].sum / of[1].count : 0, 100 * of[1].worst);
}

void report_terminal(const struct plan *p, FILE *f)
{
    char a[64], b[32];
    fprintf(f, "%-19s %-62s %14s %10s %-7s %8s  %-8s %s\n", "run", "", "published", "simulated", "", "error",
            "", "");
    for (size_t i = 0; i < p->curve_count; i++) {
        const struct curve *c = &p->curves[i];
        fprintf(f, "%-19s %-62.62s %14s %4zu points %-2s %+6.1f %%  %-8s %s\n", c->run->name, c->text,
                "formula", c->points, "", 100 * c->worst, verdict_name(c->verdict), c->standing);
    }
    for (size_t i = 0; i < p->figure_count; i++) {
        const struct figure *g = &p->figures[i];
        fprintf(f, "%-19s %-62.62s %14s %10.5g %-7s %8s  %-8s %s\n", g->run->name, g->text, published(g, a),
                g->simulated, g->unit, error_of(g, b), verdict_name(g->verdict), g->standing);
    }
    print_errors(p, f);
}

static void page_figures(const struct plan *p, FILE *f)
{
    char a[64], b[32];
    fputs("\n| run | figure | published | simulated | error | | standing | source |\n"
          "|---|---|---|---|---|---|---|---|\n",
          f);
    for (size_t i = 0; i < p->figure_count; i++) {
        const struct figure *g = &p->figures[i];
        fprintf(f, "| %s | %s | %s | %.5g %s | %s | %s | %s | %s%s%s |\n", g->run->name, g->text,
                published(g, a), g->simulated, g->unit, error_of(g, b), verdict_name(g->verdict), g->standing,
                g->source, g->verdict == KNOWN_MISS ? " Why: " : "", g->verdict == KNOWN_MISS ? g->miss : "");
    }
}

static void page_curves(const struct plan *p, FILE *f)
{
    fputs(
        "\n| run | formula, n bytes over d hops, microseconds | points | worst error | at n, d | | standing "
        "| source |\n|---|---|---|---|---|---|---|---|\n",
        f);
    for (size_t i = 0; i < p->curve_count; i++) {
        const struct curve *c = &p->curves[i];
        fprintf(f, "| %s | %s | %zu | %+.1f %% | %g, %g | %s | %s | %s |\n", c->run->name, c->text, c->points,
                100 * c->worst, c->worst_at ? c->worst_at->x[0] : 0, c->worst_at ? c->worst_at->x[1] : 0,
                verdict_name(c->verdict), c->standing, c->source);
    }
}

/* The n-th series of a run in order of appearance; NULL: there is none. */
static const char *nth_series(const struct run *r, size_t n)
{
    for (size_t i = 0; i < r->point_count; i++) {
        bool seen = false;
        for (size_t k = 0; k < i; k++)
            seen = seen || strcmp(r->points[k].series, r->points[i].series) == 0;
        if (!seen && n-- == 0)
            return r->points[i].series;
    }
    return NULL;
}

/* A table: a column of x, then a column of y for each series. */
static void page_listing(const struct listing *l, FILE *f)
{
    const struct run *r = l->run;
    const char *first = nth_series(r, 0), *s;
    fprintf(f, "\n**%s** (%s)\n\n| %s |", l->title, l->y, l->x);
    for (size_t n = 0; (s = nth_series(r, n)); n++)
        fprintf(f, " %s |", s);
    fputs("\n|---|", f);
    for (size_t n = 0; nth_series(r, n); n++)
        fputs("---|", f);
    for (size_t i = 0; i < r->point_count; i++) {
        if (strcmp(r->points[i].series, first) != 0)
            continue;
        fprintf(f, "\n| %g |", r->points[i].x[0]);
        for (size_t n = 0; (s = nth_series(r, n)); n++)
            for (size_t k = 0; k < r->point_count; k++)
                if (strcmp(r->points[k].series, s) == 0 && r->points[k].x[0] == r->points[i].x[0])
                    fprintf(f, " %.1f |", r->points[k].y);
    }
    fputc('\n', f);
}

void report_page(const struct plan *p, FILE *f)
{
    fputs(
        "# Microbenchmarks: published figures and simulated ones\n\nWritten by `make validate`; do not edit. "
        "The programs are the `.c` files beside this page, the published figures\nand what is run "
        "`published.cfg`; pictures go to `out/validate/`. An error is counted from the nearer end of a\n"
        "range. *within*: no more than 5 % off, or as the row says; *misses*: outside, with the reason; "
        "*open*: no\npublished figure was found, and the simulated one stands alone. Standing of a published "
        "figure: *read* from a copy of the\nsource; *known*: widely quoted from the source, whose table was "
        "not at hand; *derived*: arithmetic on those.\n\n## Formulas\n",
        f);
    page_curves(p, f);
    fputs("\n## Figures\n", f);
    page_figures(p, f);
    fputs("\n## Series for which no published figures were found\n", f);
    for (size_t i = 0; i < p->listing_count; i++)
        page_listing(&p->listings[i], f);
    fputs("\n## Remarks\n", f);
    for (size_t i = 0; i < p->remark_count; i++)
        fprintf(f, "\n%s\n", p->remarks[i]);
    print_errors(p, f);
}
