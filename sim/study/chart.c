/* chart.c - see chart.h.
 *
 * One panel for each value of the panels' axis, in it one line for each value of the lines' axis. A data block is a
 * line: $dPANEL_LINE. What is drawn at x is the figure of the point there; or of several points, which differ in the
 * axis `best`, that axis's value at the one with the least figure.
 */
#include "study/chart.h"

#include <math.h>
#include <string.h>

enum { MAX_PANELS = 64, MAX_LINES = 64 };

/* What a panel has. */
struct panel {
    bool line[MAX_LINES]; /* is there anything of it? */
    double low, high;     /* of all that is drawn; high < low: nothing */
};

/* Of how many values an axis is, and what they are called; one without a name where there is no axis. */
static size_t count_of(const struct spec_axis *axis)
{
    return axis ? axis->count : 1;
}

static const char *label_of(const struct spec_axis *axis, size_t i)
{
    return axis ? axis->values[i].label : "";
}

/* Where a value is drawn: numbers where they are, texts at 1, 2, 3 ... */
static double position(const struct spec_axis *axis, size_t i)
{
    return axis->numeric ? axis->values[i].number : (double)(i + 1);
}

static bool is_at(const struct points *p, const struct point *point, const struct spec_axis *axis, size_t i)
{
    return !axis || point->at[spec_place(p->spec, axis)] == i;
}

/* What is drawn at that place; NAN if nothing is. */
static double drawn_at(const struct points *p, const struct spec_picture *c, size_t panel, size_t line,
                       size_t x)
{
    double least = INFINITY, drawn = NAN;
    for (size_t i = 0; i < p->count; i++) {
        const struct point *point = &p->point[i];
        double figure = points_figure(point, c->figure);
        if (!is_at(p, point, c->panels, panel) || !is_at(p, point, c->lines, line) ||
            !is_at(p, point, c->x, x) || !(figure < least))
            continue;
        least = figure;
        drawn = c->best ? position(c->best, point->at[spec_place(p->spec, c->best)]) : figure;
    }
    return drawn;
}

/* A data block. */
static void write_line(const struct points *p, const struct spec_picture *c, size_t number, size_t line,
                       struct panel *panel, FILE *out)
{
    fprintf(out, "$d%zu_%zu << END\n", number, line);
    for (size_t x = 0; x < c->x->count; x++) {
        double y = drawn_at(p, c, number, line, x);
        if (isnan(y))
            continue;
        fprintf(out, "%.9g %.9g\n", position(c->x, x), y);
        panel->line[line] = true;
        panel->low = fmin(panel->low, y);
        panel->high = fmax(panel->high, y);
    }
    fputs("END\n", out);
}

/* Single quotes hold anything but themselves, which are doubled. */
static void write_quoted(const char *text, FILE *out)
{
    fputc('\'', out);
    for (; *text; text++) {
        if (*text == '\'')
            fputc('\'', out);
        fputc(*text, out);
    }
    fputc('\'', out);
}

static void write_words(const char *before, const char *text, FILE *out)
{
    fputs(before, out);
    write_quoted(text, out);
    fputc('\n', out);
}

/* The values of an axis are its tics. */
static void write_tics(char which, const struct spec_axis *axis, bool log, FILE *out)
{
    double first = position(axis, 0), last = first;
    fprintf(out, "set %ctics (", which);
    for (size_t i = 0; i < axis->count; i++) {
        write_quoted(axis->values[i].label, out);
        fprintf(out, " %.9g%s", position(axis, i), i + 1 < axis->count ? ", " : ")\n");
        first = fmin(first, position(axis, i));
        last = fmax(last, position(axis, i));
    }
    double room = first == last ? 1 : (last - first) / 16;
    if (log && first > 0)
        fprintf(out, "set logscale %c\nset %crange [%.9g:%.9g]\n", which, which, first / 1.25, last * 1.25);
    else
        fprintf(out, "set %crange [%.9g:%.9g]\n", which, first - room, last + room);
}

static void write_frame(const struct spec_picture *c, FILE *out)
{
    write_words("set xlabel ", *c->x_label ? c->x_label : c->x->name, out);
    write_words("set ylabel ", *c->y_label ? c->y_label : c->best ? c->best->name : c->figure, out);
    fputs("set grid xtics ytics back lt 1 lw 0.6 lc rgb '#d8d8d8'\n"
          "set border 3\nset tics nomirror\n",
          out);
    write_tics('x', c->x, c->log_x, out);
    if (c->best)
        write_tics('y', c->best, c->log_y, out);
}

/* Tics of a logarithmic axis, near enough to read values by. */
static void write_log_tics(double low, double high, FILE *out)
{
    static const double steps[] = {1, 1.5, 2, 3, 4, 6, 8};
    const char *comma = "";
    fputs("set ytics (", out);
    for (double power = pow(10, floor(log10(low))); power <= high; power *= 10)
        for (size_t i = 0; i < sizeof steps / sizeof *steps; i++)
            if (power * steps[i] >= low && power * steps[i] <= high) {
                fprintf(out, "%s%.9g", comma, power * steps[i]);
                comma = ", ";
            }
    fputs(")\n", out);
}

/* Each panel has its own range; one of less than a factor of two is linear in any case. */
static void write_range(const struct spec_picture *c, const struct panel *panel, FILE *out)
{
    bool log = c->log_y && panel->low > 0 && panel->high >= 2 * panel->low;
    double room = (panel->high - panel->low) / 12 + (panel->high == panel->low);
    double low = log ? panel->low / 1.15 : panel->low - room,
           high = log ? panel->high * 1.15 : panel->high + room;
    if (c->best)
        return; /* its axis has set it */
    fputs(log ? "set logscale y\n" : "unset logscale y\nset ytics autofreq\n", out);
    if (log)
        write_log_tics(low, high, out);
    fprintf(out, "set yrange [%.9g:%.9g]\n", low, high);
}

static void write_panel(const struct spec_picture *c, size_t number, const struct panel *panel, FILE *out)
{
    static const char *const colours[] = {"#404040", "#c04000", "#0060ad", "#2e8b57",
                                          "#8b4fae", "#c8a000", "#d6629a", "#4fb0c6"};
    enum { COLOURS = sizeof colours / sizeof *colours };
    size_t lines = count_of(c->lines);
    char title[256];
    snprintf(title, sizeof title, "%s %s", c->panels ? c->panels->name : "", label_of(c->panels, number));
    write_words("set title ", title, out);
    fputs(lines > 1 ? "set key bmargin center horizontal samplen 1.5 height 1.5\n" : "unset key\n", out);
    write_range(c, panel, out);
    const char *before = "plot";
    for (size_t line = 0; line < lines; line++) {
        if (!panel->line[line])
            continue;
        /* Lines that meet are still all seen: the later ones are thinner. */
        double over = (double)(lines - line - 1);
        fprintf(out, "%s $d%zu_%zu with linespoints lw %.1f pt 7 ps %.2f lc rgb '%s' title ", before, number,
                line, 1.6 + 1.3 * over, 0.6 + 0.3 * over, colours[line % COLOURS]);
        write_quoted(label_of(c->lines, line), out);
        before = ",";
    }
    fputs("\n", out);
}

/* All panels, as a picture of that kind. */
static void write_page(const struct spec_picture *c, const struct panel panel[], bool svg, const char *dir,
                       FILE *out)
{
    size_t panels = count_of(c->panels);
    unsigned columns = panels < 4 ? (unsigned)panels : (unsigned)ceil(sqrt((double)panels));
    unsigned rows = ((unsigned)panels + columns - 1) / columns;
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.%s", dir, c->file, svg ? "svg" : "png");
    fprintf(out, "set terminal %s size %u,%u font 'Sans,%d'\n",
            svg ? "svg noenhanced background rgb 'white'" : "pngcairo noenhanced",
            panels == 1 ? 760 : 560 * columns, 400 * rows + 40, svg ? 12 : 10);
    write_words("set output ", path, out);
    fprintf(out, "set multiplot layout %u,%u title heading font ',13'\n", rows, columns);
    for (size_t i = 0; i < panels; i++)
        if (panel[i].high >= panel[i].low)
            write_panel(c, i, &panel[i], out);
    fputs("unset multiplot\n", out);
}

/* The study's title and the picture's. */
static void write_heading(const struct spec *s, const struct spec_picture *c, FILE *out)
{
    char heading[512];
    snprintf(heading, sizeof heading, "%s%s%s", s->title, *s->title && *c->title ? ": " : "", c->title);
    write_words("heading = ", heading, out);
}

bool chart_write(const struct points *p, const struct spec_picture *c, const char *dir, FILE *script)
{
    struct panel panel[MAX_PANELS];
    bool any = false;
    if (count_of(c->panels) > MAX_PANELS || count_of(c->lines) > MAX_LINES)
        return false;
    for (size_t i = 0; i < count_of(c->panels); i++) {
        panel[i] = (struct panel){.low = INFINITY, .high = -INFINITY};
        for (size_t line = 0; line < count_of(c->lines); line++)
            write_line(p, c, i, line, &panel[i], script);
        any |= panel[i].high >= panel[i].low;
    }
    if (!any)
        return false;
    write_heading(p->spec, c, script);
    write_frame(c, script);
    write_page(c, panel, false, dir, script);
    write_page(c, panel, true, dir, script);
    return true;
}
