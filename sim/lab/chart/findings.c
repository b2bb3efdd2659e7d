/* findings.c - see findings.h.
 *
 * The sentences under a table follow from its figures: where each line is best, the range in which the line
 * stays within a tenth of its best, and which line is best where.
 */
#include "lab/chart/findings.h"
#include "files/atomic_file.h"
#include "files/virtual_time.h"
#include "kernel/xalloc.h"
#include "lab/chart/chart_data.h"
#include "files/words.h"

#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double TENTH = 0.1;

struct page {
    const struct record_points *points;
    const struct picture *picture;
    const struct chart_data *data;
    FILE *out;
};

/* --- what was run --------------------------------------------------------------------------------------- */

struct tally {
    size_t points, failed;
};

static bool count_point(void *arg, const json_t *point, char **error)
{
    struct tally *t = arg;
    (void)error;
    t->points++;
    t->failed += json_is_string(json_object_get(point, "failure"));
    return true;
}

static const char *text_in(const json_t *object, const char *key)
{
    const char *text = json_string_value(json_object_get(object, key));
    return text ? text : "";
}

static bool write_head(const struct record_points *points, FILE *out, char **error)
{
    struct tally t = {0};
    size_t combinations = 1;
    const char *name, *before = "", *about = text_in(points->header, "about");
    json_t *values;
    if (!points->each(points->arg, count_point, &t, error))
        return false;
    fprintf(out, "# %s\n\nWritten by `touchstone study` from its results; do not edit.\n\n",
            text_in(points->header, "title"));
    if (*about)
        fprintf(out, "%s\n\n", about);
    fprintf(out, "%s at %zu point%s: ", text_in(points->header, "program"), t.points,
            t.points == 1 ? "" : "s");
    json_object_foreach(json_object_get(points->header, "axes"), name, values)
    {
        size_t count = json_array_size(values);
        fprintf(out, "%s%zu%s of %s", before, count, *before ? "" : count == 1 ? " value" : " values", name);
        before = ", ";
        combinations *= json_array_size(values);
    }
    fputs(".", out);
    if (combinations > t.points)
        fprintf(out, " The study's `only` leaves out %zu combination%s.", combinations - t.points,
                combinations - t.points == 1 ? "" : "s");
    fputs("\n", out);
    if (t.failed)
        fprintf(out, "%zu failed, and are not below.\n", t.failed);
    return true;
}

/* --- a table -------------------------------------------------------------------------------------------- */

static const char *what(const struct page *p)
{
    return p->data->y_label;
}

/* Digits before the point; -1 for 0.01. */
static int whole_digits(double v)
{
    return v == 0 ? 1 : (int)floor(log10(fabs(v))) + 1;
}

/* The range of figures' digits before the point. */
struct range {
    int least, most;
};

static struct range widen(struct range r, const struct page *p, size_t panel, size_t line)
{
    for (size_t x = 0; x < p->data->x.count; x++) {
        double v = chart_at(p->data, panel, line, x);
        if (isnan(v))
            continue;
        int whole = whole_digits(v);
        r.least = whole < r.least ? whole : r.least;
        r.most = whole > r.most ? whole : r.most;
    }
    return r;
}

/* The decimals of a table, whose figures are of one kind, so that equal ones read alike: four digits for its
 * least figure. If its largest one would have more than six, each column has its own; if also a column's
 * would, six digits for that one. Whole parts are never cut. */
static int decimals_of(const struct page *p, size_t panel, size_t line)
{
    enum { DIGITS = 4, MOST_DIGITS = 6 };
    const struct range none = {INT_MAX, INT_MIN};
    struct range table = none, column = widen(none, p, panel, line);
    for (size_t i = 0; i < p->data->lines.count; i++)
        table = widen(table, p, panel, i);
    if (column.least > column.most)
        return 0;
    struct range r = DIGITS - table.least <= MOST_DIGITS - table.most ? table : column;
    int decimals = DIGITS - r.least > MOST_DIGITS - r.most ? MOST_DIGITS - r.most : DIGITS - r.least;
    return decimals > 0 ? decimals : 0;
}

/* Writes a figure with its column's decimals. */
static void write_value(const struct page *p, size_t panel, size_t line, size_t x)
{
    fprintf(p->out, "%.*f", decimals_of(p, panel, line), chart_at(p->data, panel, line, x));
}

/* Writes a cell: the figure, or the label of the best axis's value. */
static void write_cell(const struct page *p, size_t panel, size_t line, size_t x)
{
    const struct chart_axis *best = &p->data->best;
    double v = chart_at(p->data, panel, line, x);
    if (isnan(v)) {
        fputc('-', p->out);
        return;
    }
    for (size_t i = 0; *best->name && i < best->count; i++)
        if (best->position[i] == v) {
            fputs(best->label[i], p->out);
            return;
        }
    write_value(p, panel, line, x);
}

static const char *line_name(const struct page *p, size_t line)
{
    return *p->data->lines.name ? p->data->lines.label[line] : what(p);
}

/* Writes "group 8", "8 nodes", and of an axis without a name only the label. */
static void write_place(const struct page *p, const char *axis, const char *label)
{
    if (strcmp(axis, "nodes") == 0)
        fprintf(p->out, "%s node%s", label, strcmp(label, "1") != 0 ? "s" : "");
    else
        fprintf(p->out, "%s%s%s", axis, *axis ? " " : "", label);
}

/* Writes "group 8 to 16", "8 to 16 nodes". */
static void write_range(const struct page *p, size_t from, size_t to)
{
    const struct chart_axis *x = &p->data->x;
    char *labels = xasprintf("%s to %s", x->label[from], x->label[to]);
    write_place(p, x->name, from == to ? x->label[from] : labels);
    free(labels);
}

/* A column's head: the line's name, and with a mere number what it is the value of: "group 8". */
static void write_column_head(const struct page *p, size_t line)
{
    const char *name = line_name(p, line);
    fputc(' ', p->out);
    write_place(p, isdigit((unsigned char)*name) ? p->data->lines.name : "", name);
    fputs(" |", p->out);
}

static void write_table(const struct page *p, size_t panel)
{
    const struct chart_data *d = p->data;
    fprintf(p->out, "| %s |", *p->picture->x_label ? p->picture->x_label : d->x.name);
    for (size_t line = 0; line < d->lines.count; line++)
        write_column_head(p, line);
    fputs("\n|--:|", p->out);
    for (size_t line = 0; line < d->lines.count; line++)
        fputs("--:|", p->out);
    fputc('\n', p->out);
    for (size_t x = 0; x < d->x.count; x++) {
        fprintf(p->out, "| %s |", d->x.label[x]);
        for (size_t line = 0; line < d->lines.count; line++) {
            fputc(' ', p->out);
            write_cell(p, panel, line, x);
            fputs(" |", p->out);
        }
        fputc('\n', p->out);
    }
    fputc('\n', p->out);
}

/* --- what can be read off it ---------------------------------------------------------------------------- */

/* A number that is lower for a better figure: higher speeds are better, of all other figures lower values. */
static double merit(const struct page *p, size_t panel, size_t line, size_t x)
{
    double v = chart_at(p->data, panel, line, x);
    return strncmp(p->picture->figure, "speed", 5) == 0 ? -v : v;
}

static const char *best_word(const struct page *p)
{
    return strncmp(p->picture->figure, "speed", 5) == 0 ? "most" : "least";
}

/* The x at which a line is best; d->x.count if the line has no points. */
static size_t best_of(const struct page *p, size_t panel, size_t line)
{
    const struct chart_data *d = p->data;
    size_t at = d->x.count;
    for (size_t x = 0; x < d->x.count; x++) {
        double v = merit(p, panel, line, x);
        if (!isnan(v) && (at == d->x.count || v < merit(p, panel, line, at)))
            at = x;
    }
    return at;
}

/* Writes "8 nodes"; or of names all at which the line is as good: "machine delta and paragon". */
static void write_best(const struct page *p, size_t panel, size_t line, size_t at)
{
    const struct chart_axis *x = &p->data->x;
    char *names = xstrdup(x->label[at]);
    for (size_t i = at + 1; i < x->count && !x->numeric; i++)
        if (merit(p, panel, line, i) == merit(p, panel, line, at))
            words_append(&names, " and %s", x->label[i]);
    write_place(p, x->name, names);
    free(names);
}

/* The range around `at` in which the line stays within a tenth of its best. */
static void near_best(const struct page *p, size_t panel, size_t line, size_t at, size_t *from, size_t *to)
{
    double best = merit(p, panel, line, at), most = best + TENTH * fabs(best);
    for (*from = at; *from > 0 && merit(p, panel, line, *from - 1) <= most;)
        --*from;
    for (*to = at; *to + 1 < p->data->x.count && merit(p, panel, line, *to + 1) <= most;)
        ++*to;
}

static bool is_time(const char *figure)
{
    size_t n = strlen(figure);
    return strcmp(figure, "total_s") == 0 || (n >= 6 && strcmp(figure + n - 6, "time_s") == 0);
}

/* Writes "142 times faster", of other figures than times "142 times lower"; below twice "25 % less". */
static void say_factor(const struct page *p, double from, double to)
{
    bool time = is_time(p->picture->figure), down = to < from;
    double factor = down ? from / to : to / from;
    char text[32];
    snprintf(text, sizeof text, "%.3g", 100 * fabs(to / from - 1));
    if (factor >= 2)
        fprintf(p->out, "%.*f times %s",
                factor < 10    ? 2
                : factor < 100 ? 1
                               : 0,
                factor, time ? (down ? "faster" : "slower") : (down ? "lower" : "higher"));
    else if (strtod(text, NULL) < 0.01)
        fputs("the same", p->out);
    else
        fprintf(p->out, "%s %% %s", text, down ? "less" : "more");
}

/* Writes "8.000 to 6.000 from 1 to 8 nodes, 25 % less; ". Names have no first and last. */
static void say_change(const struct page *p, size_t panel, size_t line)
{
    const struct chart_data *d = p->data;
    size_t first = 0, last = d->x.count - 1;
    while (first < last && isnan(chart_at(d, panel, line, first)))
        first++;
    while (last > first && isnan(chart_at(d, panel, line, last)))
        last--;
    double from = chart_at(d, panel, line, first), to = chart_at(d, panel, line, last);
    if (!d->x.numeric || first == last || !(from > 0) || !(to > 0))
        return;
    write_value(p, panel, line, first);
    fputs(" to ", p->out);
    write_value(p, panel, line, last);
    fputs(" from ", p->out);
    write_range(p, first, last);
    fputs(", ", p->out);
    say_factor(p, from, to);
    fputs("; ", p->out);
}

/* Has the line several points, and all of one value? */
static bool is_level(const struct chart_data *d, size_t panel, size_t line)
{
    size_t count = 0;
    double low = INFINITY, high = -INFINITY;
    for (size_t x = 0; x < d->x.count; x++) {
        low = fmin(low, chart_at(d, panel, line, x));
        high = fmax(high, chart_at(d, panel, line, x));
        count += !isnan(chart_at(d, panel, line, x));
    }
    return count > 1 && low == high;
}

static void say_best(const struct page *p, size_t panel, size_t line)
{
    const struct chart_data *d = p->data;
    size_t at = best_of(p, panel, line), from, to;
    if (at == d->x.count)
        return;
    near_best(p, panel, line, at, &from, &to);
    fputs("- ", p->out);
    write_place(p, d->lines.name, line_name(p, line));
    fputs(": ", p->out);
    if (is_level(d, panel, line)) {
        write_value(p, panel, line, at);
        fputs(" at all points.\n", p->out);
        return;
    }
    say_change(p, panel, line);
    fprintf(p->out, "%s, ", best_word(p));
    write_value(p, panel, line, at);
    fputs(", at ", p->out);
    write_best(p, panel, line, at);
    if (from < to && d->x.numeric)
        fprintf(p->out, "; within a tenth of it from %s to %s", d->x.label[from], d->x.label[to]);
    fputs(".\n", p->out);
}

/* The best value at x; NAN if fewer than two lines differ there. */
static double best_at(const struct page *p, size_t panel, size_t x)
{
    double best = NAN;
    bool differ = false;
    for (size_t line = 0; line < p->data->lines.count; line++) {
        double v = merit(p, panel, line, x);
        differ |= !isnan(v) && !isnan(best) && v != best;
        best = fmin(best, v);
    }
    return differ ? best : NAN;
}

static bool same_winners(const struct page *p, size_t panel, size_t x, size_t other)
{
    double best = best_at(p, panel, x), other_best = best_at(p, panel, other);
    for (size_t line = 0; line < p->data->lines.count; line++)
        if ((merit(p, panel, line, x) == best) != (merit(p, panel, line, other) == other_best))
            return false;
    return true;
}

/* Writes "machine delta", or "machine delta and paragon", which have the same value. */
static void write_winners(const struct page *p, size_t panel, size_t x)
{
    const struct chart_data *d = p->data;
    double best = best_at(p, panel, x);
    char *names = xstrdup("");
    for (size_t line = 0; line < d->lines.count; line++)
        if (merit(p, panel, line, x) == best)
            words_append(&names, "%s%s", *names ? " and " : "", line_name(p, line));
    write_place(p, d->lines.name, names);
    free(names);
}

static void say_winners(const struct page *p, size_t panel)
{
    const struct chart_data *d = p->data;
    bool any = false;
    for (size_t x = 0; x < d->x.count;) {
        size_t end = x + 1;
        while (end < d->x.count && same_winners(p, panel, x, end))
            end++;
        if (!isnan(best_at(p, panel, x))) {
            if (any)
                fputs("; ", p->out);
            else
                fprintf(p->out, "- The %s line: ", strcmp(best_word(p), "most") ? "lowest" : "highest");
            write_winners(p, panel, x);
            fputs(" at ", p->out);
            write_range(p, x, end - 1);
            any = true;
        }
        x = end;
    }
    fputs(any ? ".\n" : "", p->out);
}

static void write_panel(const struct page *p, size_t panel)
{
    const struct chart_data *d = p->data;
    if (*d->panels.name)
        fprintf(p->out, "### %s %s\n\n", d->panels.name, d->panels.label[panel]);
    write_table(p, panel);
    if (*d->best.name || *d->ratio.name || d->x.count < 2)
        return;
    for (size_t line = 0; line < d->lines.count; line++)
        say_best(p, panel, line);
    if (d->lines.count > 1)
        say_winners(p, panel);
    fputc('\n', p->out);
}

/* So that a label is text, and no mark that ends a cell or begins HTML. */
static void escape_labels(const struct chart_axis *a)
{
    static const char *const MARKS[][2] = {{"|", "\\|"}, {"<", "&lt;"}, {"\n", " "}};
    for (size_t i = 0; i < a->count; i++)
        for (size_t k = 0; k < sizeof MARKS / sizeof *MARKS; k++) {
            char *marked = a->label[i];
            a->label[i] = words_filled(marked, MARKS[k][0], MARKS[k][1]);
            free(marked);
        }
}

static bool write_picture(const struct record_points *points, const struct picture *picture, FILE *out,
                          char **error)
{
    struct chart_data data;
    bool ok = chart_data_take(points, picture, &data, error);
    if (ok) {
        struct page page = {points, picture, &data, out};
        const struct chart_axis *const axes[] = {&data.x, &data.lines, &data.panels, &data.best};
        for (size_t i = 0; i < sizeof axes / sizeof *axes; i++)
            escape_labels(axes[i]);
        const char *title = *picture->title ? picture->title : picture->file;
        fprintf(out, "\n## %s\n\n![%s](%s.png)\n\n", title, title, picture->file);
        const char *baseline = chart_baseline(points->header, picture);
        bool named = *picture->best && *picture->y_label;
        fprintf(out, "In the table: %s%s%s%s%s%s%s%s%s.\n\n", what(&page), named ? " with the least " : "",
                named ? picture->figure : "", *picture->lines_label ? "; columns: " : "",
                picture->lines_label, *data.fixed ? "; " : "", data.fixed, *baseline ? "; baseline: " : "",
                baseline);
        for (size_t i = 0; i < data.panels.count; i++)
            write_panel(&page, i);
    }
    chart_data_free(&data);
    return ok;
}

/* What the only point took: a study of one has no picture. */
static bool say_point(void *arg, const json_t *point, char **error)
{
    FILE *out = arg;
    (void)error;
    if (json_is_string(json_object_get(point, "failure")))
        return true;
    const json_t *idle = json_object_get(point, "idle_pct");
    fprintf(out, "\nTime: %s.", duration_text(json_number_value(json_object_get(point, "time_s"))).text);
    if (idle)
        fprintf(out, " Idle: %.4g %% of all nodes' time.", json_number_value(idle));
    fputc('\n', out);
    return true;
}

bool findings_write(const struct record_points *points, const struct picture *list, size_t count,
                    const char *dir, char **error)
{
    struct atomic_file d;
    char *path = xasprintf("%s/findings.md", dir);
    bool begun = atomic_file_begin(&d, path, error);
    free(path);
    if (!begun)
        return false;
    bool ok = write_head(points, d.out, error);
    if (ok && !count) {
        ok = points->each(points->arg, say_point, d.out, error);
        fputs("\nNo axis has several values, so there is no picture. All figures are in results.csv.\n",
              d.out);
    }
    for (size_t i = 0; ok && i < count; i++)
        ok = write_picture(points, &list[i], d.out, error);
    if (ok)
        return atomic_file_end(&d, error);
    atomic_file_drop(&d);
    return false;
}
