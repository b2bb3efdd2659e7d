/* chart_script.c - see chart_script.h.
 *
 * A picture has a panel for each value of the panels' axis; all panels have the same axes. In each panel the
 * lines are drawn first, then the markers, the larger ones first; the legend is one for all panels.
 */
#include "lab/chart/chart_script.h"
#include "kernel/xalloc.h"
#include "lab/chart/chart_layout.h"
#include "lab/chart/chart_marks.h"
#include "lab/chart/chart_style.h"
#include "files/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char IDEAL[] = "ideal";
enum { LEAST_LINE = 720 }; /* a heading as wide is one line, also of a picture that is narrower */

struct script {
    const struct picture *picture;
    const struct chart_data *data;
    char *heading; /* lay_out() breaks it into lines */
    const char *notes;
    struct scale x;
    struct scale *y;   /* of each panel */
    const char *ideal; /* the ideal line as gnuplot's expression in x; NULL: there is none */
    bool choices;      /* no lines between points */
    struct layout layout;
    FILE *out;
};

/* --- ranges --------------------------------------------------------------------------------------------- */

struct range {
    double low, high; /* high < low: there are no values */
};

static struct range range_of_panel(const struct chart_data *d, size_t panel)
{
    struct range r = {INFINITY, -INFINITY};
    for (size_t line = 0; line < d->lines.count; line++)
        for (size_t x = 0; x < d->x.count; x++) {
            r.low = fmin(r.low, chart_at(d, panel, line, x));
            r.high = fmax(r.high, chart_at(d, panel, line, x));
        }
    return r;
}

/* With ideal speeds beside them, which are 1 a node. */
static struct range with_ideal(const struct script *s, struct range r)
{
    const struct chart_axis *x = &s->data->x;
    for (size_t i = 0; s->ideal && i < x->count; i++) {
        double ideal = *s->ideal == 'x' ? x->position[i] : 1;
        r = (struct range){fmin(r.low, ideal), fmax(r.high, ideal)};
    }
    return r;
}

/* Sets the panels' scales: the same for all, or a range of each panel's own. Either all are logarithmic, or
 * none. False if there are no values. */
static bool set_scales(struct script *s)
{
    struct range all = {INFINITY, -INFINITY};
    bool log = s->picture->log_y;
    size_t panels = s->data->panels.count;
    for (size_t i = 0; i < panels; i++) {
        struct range r = range_of_panel(s->data, i);
        if (r.high < r.low)
            continue;
        all = (struct range){fmin(all.low, r.low), fmax(all.high, r.high)};
        if (s->picture->own_ranges)
            log = log && scale_may_be_log(r.low, r.high);
    }
    if (all.high < all.low)
        return false;
    all = with_ideal(s, all);
    for (size_t i = 0; i < panels; i++) {
        struct range own = with_ideal(s, range_of_panel(s->data, i));
        struct range r = s->picture->own_ranges && own.high >= own.low ? own : all;
        s->y[i] = *s->picture->best ? scale_of_axis(&s->data->best, s->picture->log_y)
                                    : scale_of_values(r.low, r.high, log);
    }
    return true;
}

/* --- data ----------------------------------------------------------------------------------------------- */

static bool has_points(const struct chart_data *d, size_t panel, size_t line)
{
    for (size_t x = 0; x < d->x.count; x++)
        if (!isnan(chart_at(d, panel, line, x)))
            return true;
    return false;
}

static bool in_any_panel(const struct chart_data *d, size_t line)
{
    for (size_t panel = 0; panel < d->panels.count; panel++)
        if (has_points(d, panel, line))
            return true;
    return false;
}

static struct line_style style_in(const struct script *s, size_t line)
{
    return style_of(line, s->data->lines.count, s->data->lines.numeric);
}

static void write_lines(const struct script *s, size_t panel, size_t line)
{
    const struct chart_data *d = s->data;
    fprintf(s->out, "$l%zu_%zu << END\n", panel, line);
    for (size_t x = 0; x < d->x.count; x++)
        if (!isnan(chart_at(d, panel, line, x)))
            fprintf(s->out, "%.9g %.9g\n", d->x.position[x], chart_at(d, panel, line, x));
    fputs("END\n", s->out);
}

static void write_marks(const struct script *s, size_t panel, size_t line)
{
    const struct chart_data *d = s->data;
    struct mark *marks = xcalloc(d->lines.count, sizeof *marks);
    int marker = style_in(s, line).marker;
    fprintf(s->out, "$m%zu_%zu << END\n", panel, line);
    for (size_t x = 0; x < d->x.count; x++) {
        double y = chart_at(d, panel, line, x);
        if (isnan(y))
            continue;
        marks_of(d, panel, x, &s->x, &s->y[panel], marks);
        const struct mark *m = &marks[line];
        if (!isnan(m->size))
            fprintf(s->out, "%.9g %.9g %.3g %d\n", m->x, y, 0.9 * m->size,
                    m->hollow ? style_hollow(marker) : marker);
    }
    fputs("END\n", s->out);
    free(marks);
}

static void write_data(const struct script *s)
{
    const struct chart_data *d = s->data;
    for (size_t panel = 0; panel < d->panels.count; panel++)
        for (size_t line = 0; line < d->lines.count; line++) {
            if (!s->choices)
                write_lines(s, panel, line);
            write_marks(s, panel, line);
        }
}

/* --- text ----------------------------------------------------------------------------------------------- */

static void write_words(const char *before, const char *text, FILE *out)
{
    fputs(before, out);
    scale_write_quoted(text, out);
    fputc('\n', out);
}

/* As a text of gnuplot, of several lines. */
static void write_heading(const char *text, FILE *out)
{
    fputs("heading = ", out);
    char *rest = xstrdup(text), *next = rest;
    for (char *line; (line = strsep(&next, "\n"));) {
        scale_write_quoted(line, out);
        fputs(next ? ".\"\\n\"." : "\n", out);
    }
    free(rest);
}

/* The line's label, malloc'd; if another line hides it, also that line's: "groups of 8 (= one host)". */
static char *entry_of(const struct chart_data *d, size_t line)
{
    size_t same = marks_same_line(d, line);
    return same == line ? xstrdup(d->lines.label[line])
                        : xasprintf("%s (= %s)", d->lines.label[line], d->lines.label[same]);
}

/* What the reader must know beside the heading: axes held at a value, the baseline of speeds, unlike ranges;
 * malloc'd. */
static char *notes_of(const json_t *header, const struct picture *p, const struct chart_data *d)
{
    const char *baseline = chart_baseline(header, p);
    char *notes = xstrdup(d->fixed);
    if (*baseline)
        words_append(&notes, "%sbaseline: %s", *notes ? "; " : "", baseline);
    if (p->own_ranges && d->panels.count > 1)
        words_append(&notes, "%seach panel has a range of its own", *notes ? "; " : "");
    return notes;
}

static char *heading_of(const json_t *header, const struct picture *p)
{
    const char *study = json_string_value(json_object_get(header, "title"));
    return xasprintf("%s%s%s", study ? study : "", study && *study && *p->title ? ": " : "", p->title);
}

static const char *or_else(const char *text, const char *otherwise)
{
    return *text ? text : otherwise;
}

/* --- layout --------------------------------------------------------------------------------------------- */

/* Of the widest label of an axis of names; numbers need little. */
static unsigned widest_label(const struct chart_axis *axis)
{
    unsigned widest = 0;
    for (size_t i = 0; i < axis->count; i++) {
        unsigned width = scale_text_width(axis->label[i]);
        widest = width > widest ? width : widest;
    }
    return widest;
}

/* Labels of an axis of names that have no room side by side are turned. */
static bool are_turned(const struct script *s)
{
    const struct chart_axis *x = &s->data->x;
    return !x->numeric && (widest_label(x) + 8) * x->count > layout_panel_width(s->data->panels.count);
}

/* The room beside the panels for the numbers of their vertical axes. */
static unsigned room_for_numbers(const struct script *s)
{
    unsigned room = 60;
    for (size_t panel = 0; panel < s->data->panels.count; panel++) {
        unsigned needed = scale_widest_tic(&s->y[panel]) + 18;
        room = needed > room ? needed : room;
    }
    return room;
}

/* Adds the room for labels of names: beside the panels those of the best axis, below them turned ones, which
 * also reach to the left of the first. */
static void add_names(const struct script *s, struct layout_needs *needs)
{
    const struct chart_data *d = s->data;
    unsigned x = widest_label(&d->x), panel = layout_panel_width(needs->panels);
    if (!d->best.numeric && *d->best.name)
        needs->y_labels = widest_label(&d->best) + 20;
    if (!are_turned(s))
        return;
    needs->x_labels = x * 6 / 10 + 24;
    unsigned reach = x * 82 / 100, inside = panel / (2 * (unsigned)d->x.count);
    if (reach > inside + needs->y_labels)
        needs->y_labels = reach - inside;
}

/* Of the heading's letters from one place up to another, which are larger than others. */
static unsigned heading_width(const char *from, const char *to)
{
    return (scale_text_width(from) - scale_text_width(to)) * 4 / 3;
}

/* Breaks the heading at blanks into lines that are no wider, unless a word is: a long one would make the
 * picture many times as wide as its panels. */
static void break_heading(char *text, struct layout_needs *needs, unsigned width)
{
    char *line = text, *blank = NULL;
    needs->heading_lines = 1;
    for (char *c = text;; c++) {
        if (*c && *c != ' ')
            continue;
        if (blank && heading_width(line, c) > width) {
            *blank = '\n';
            line = blank + 1;
            needs->heading_lines++;
        }
        unsigned wide = heading_width(line, c) + 40;
        needs->heading_width = wide > needs->heading_width ? wide : needs->heading_width;
        if (!*c)
            return;
        blank = c;
    }
}

static struct layout lay_out(const struct script *s)
{
    const struct chart_data *d = s->data;
    struct layout_needs needs = {.panels = d->panels.count,
                                 .panel_titles = *d->panels.name,
                                 .notes = *s->notes,
                                 .y_labels = room_for_numbers(s),
                                 .x_labels = 24,
                                 .heading_lines = 1,
                                 .heading_width = scale_text_width(s->notes) + 40};
    add_names(s, &needs);
    needs.entry_width = scale_text_width(or_else(s->picture->lines_label, d->lines.name));
    for (size_t line = 0; *d->lines.name && line < d->lines.count; line++) {
        char *entry = entry_of(d, line);
        unsigned width = scale_text_width(entry);
        needs.entry_width = width > needs.entry_width ? width : needs.entry_width;
        needs.entries += in_any_panel(d, line);
        free(entry);
    }
    if (needs.entries == 1)
        needs.entries = 0;
    needs.entries += s->ideal != NULL;
    if (needs.entry_width < scale_text_width(IDEAL))
        needs.entry_width = scale_text_width(IDEAL);
    unsigned width = layout_of(&needs).width;
    break_heading(s->heading, &needs, width > LEAST_LINE ? width : LEAST_LINE);
    return layout_of(&needs);
}

static void write_box(const struct layout *l, const struct box *b, FILE *out)
{
    double width = l->width, height = l->height;
    fprintf(out, "set lmargin at screen %.5f\nset rmargin at screen %.5f\n", b->left / width,
            (b->left + b->width) / width);
    fprintf(out, "set tmargin at screen %.5f\nset bmargin at screen %.5f\n", 1 - b->top / height,
            1 - (b->top + b->height) / height);
}

/* --- panels --------------------------------------------------------------------------------------------- */

static void write_axes(const struct script *s, size_t panel)
{
    const struct picture *p = s->picture;
    const struct chart_data *d = s->data;
    write_words("set xlabel ", layout_is_lowest(&s->layout, panel) ? or_else(p->x_label, p->x) : "", s->out);
    write_words("set ylabel ", layout_is_left(&s->layout, panel) ? d->y_label : "", s->out);
    scale_write_axis(&s->x, 'x', &d->x, s->layout.first.width, s->out);
    if (are_turned(s))
        fputs("set xtics rotate by 35 right\n", s->out);
    if (*p->best)
        scale_write_axis(&s->y[panel], 'y', &d->best, s->layout.first.height, s->out);
    else
        scale_write(&s->y[panel], 'y', s->out);
}

/* The values of an axis of names stand between lines, and numbers on lines. */
static void write_grid(const struct script *s)
{
    const struct chart_axis *x = &s->data->x;
    fprintf(s->out, "set grid %sytics back " CHART_GRID "\nset border 3\nset tics nomirror\n",
            x->numeric ? "xtics " : "noxtics ");
    for (size_t i = 1; i < x->count && !x->numeric; i++)
        fprintf(s->out,
                "set arrow %zu from first %zu.5, graph 0 to first %zu.5, graph 1 nohead back " CHART_GRID
                "\n",
                i, i, i);
}

static void write_panel(const struct script *s, size_t panel)
{
    const struct chart_data *d = s->data;
    struct box box = layout_panel(&s->layout, panel);
    const char *before = "plot ";
    write_box(&s->layout, &box, s->out);
    char *title = *d->panels.name ? xasprintf("%s = %s", or_else(s->picture->panels_label, d->panels.name),
                                              d->panels.label[panel])
                                  : xstrdup("");
    write_words("set title ", title, s->out);
    free(title);
    write_axes(s, panel);
    if (s->ideal) {
        fprintf(s->out, "%s%s " CHART_IDEAL, before, s->ideal);
        before = ", \\\n     ";
    }
    for (size_t line = 0; !s->choices && line < d->lines.count; line++)
        if (has_points(d, panel, line)) {
            struct line_style style = style_in(s, line);
            fprintf(s->out, "%s$l%zu_%zu with lines " CHART_WIDTH " dt %s lc rgb '%s'", before, panel, line,
                    style.dash, style.colour);
            before = ", \\\n     ";
        }
    for (size_t line = 0; line < d->lines.count; line++)
        if (has_points(d, panel, line)) {
            fprintf(s->out, "%s$m%zu_%zu with points " CHART_WIDTH " ps variable pt variable lc rgb '%s'",
                    before, panel, line, style_in(s, line).colour);
            before = ", \\\n     ";
        }
    fputs("\n", s->out);
}

/* --- legend --------------------------------------------------------------------------------------------- */

/* The legend is an empty plot with a key: its title is the lines' axis, each label stands beside its own
 * sample. */
static void write_legend(const struct script *s)
{
    const struct chart_data *d = s->data;
    if (!s->layout.needs.entries)
        return;
    write_box(&s->layout, &s->layout.legend, s->out);
    fputs("unset title\nunset xlabel\nunset ylabel\nunset xtics\nunset ytics\nunset border\nunset grid\n"
          "unset arrow\nunset logscale\nset xrange [0:1]\nset yrange [0:1]\n",
          s->out);
    fprintf(s->out,
            "set key at graph 0, graph 1 left top vertical Left reverse samplen %d spacing 1.25 maxrows %u "
            "title ",
            s->choices ? 1 : 4, s->layout.legend_rows);
    scale_write_quoted(or_else(s->picture->lines_label, d->lines.name), s->out);
    fputs(" left\nplot ", s->out);
    bool lines = s->layout.needs.entries > (s->ideal != NULL);
    for (size_t line = 0; line < d->lines.count; line++) {
        if (!lines || !in_any_panel(d, line))
            continue;
        struct line_style style = style_in(s, line);
        char *entry = entry_of(d, line);
        fputs("NaN with ", s->out);
        if (s->choices)
            fputs("points ", s->out);
        else
            fprintf(s->out, "linespoints dt %s ", style.dash);
        fprintf(s->out, CHART_WIDTH " pt %d ps 0.9 lc rgb '%s' title ", style.marker, style.colour);
        scale_write_quoted(entry, s->out);
        fputs(", \\\n     ", s->out);
        free(entry);
    }
    if (s->ideal)
        fprintf(s->out, "NaN " CHART_IDEAL " title '%s'\n", IDEAL);
    else
        fputs("NaN notitle\n", s->out);
}

/* --- the whole ------------------------------------------------------------------------------------------ */

static void write_page(const struct script *s, bool svg, const char *dir)
{
    char *path = xasprintf("%s/%s.%s", dir, s->picture->file, svg ? "svg" : "png");
    style_terminal(s->out, svg, s->layout.width, s->layout.height);
    write_words("set output ", path, s->out);
    free(path);
    fputs("set multiplot title heading font ',13'\nunset key\nset samples 400\n", s->out);
    fprintf(s->out, "set label 1 notes at screen 0.5, screen %.5f center font ',9' textcolor rgb '#505050'\n",
            1 - (double)layout_notes_top(&s->layout) / s->layout.height);
    write_grid(s);
    for (size_t panel = 0; panel < s->data->panels.count; panel++) {
        write_panel(s, panel);
        fputs("unset label 1\n", s->out);
    }
    write_legend(s);
    fputs("unset multiplot\nreset\n", s->out);
}

/* Ideal speeds are known where nodes are the x axis. */
static const char *ideal_of(const struct picture *p)
{
    if (*p->best || *p->ratio || strcmp(p->x, "nodes") != 0)
        return NULL;
    return strcmp(p->figure, "speedup") == 0 ? "x" : strcmp(p->figure, "speed_per_node") == 0 ? "1" : NULL;
}

bool chart_script_write(const json_t *header, const struct picture *p, const struct chart_data *d,
                        const char *dir, FILE *out)
{
    char *heading = heading_of(header, p), *notes = notes_of(header, p, d);
    struct script s = {.picture = p,
                       .data = d,
                       .heading = heading,
                       .notes = notes,
                       .x = scale_of_axis(&d->x, p->log_x),
                       .y = xcalloc(d->panels.count, sizeof *s.y),
                       .ideal = ideal_of(p),
                       .choices = marks_are_choices(d),
                       .out = out};
    bool any = set_scales(&s);
    if (any) {
        s.layout = lay_out(&s);
        fputs("set encoding utf8\n", out);
        write_data(&s);
        write_heading(heading, out);
        write_words("notes = ", notes, out);
        write_page(&s, false, dir);
        write_page(&s, true, dir);
    }
    free(s.y);
    free(heading);
    free(notes);
    return any;
}
