/* chart.c - see chart.h.
 *
 * The picture has a panel for each value of the panels' axis, and each panel a line for each value of the
 * lines' axis. The gnuplot data block of a line is $dPANEL_LINE.
 */
#include "files/folder_make.h"
#include "kernel/xalloc.h"
#include "lab/chart/chart_parts.h"
#include "lab/jobs/process_pool.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What a panel shows. */
struct panel {
    bool line[CHART_MAX_LINES]; /* whether the line has any point */
    double low, high;           /* range of the values drawn; high < low: there are none */
};

/* Writes a line's data block and adds the line to the panel. */
static void write_line(const struct chart_data *d, size_t number, size_t line, struct panel *panel, FILE *out)
{
    fprintf(out, "$d%zu_%zu << END\n", number, line);
    for (size_t x = 0; x < d->x.count; x++) {
        double y = chart_at(d, number, line, x);
        if (isnan(y))
            continue;
        fprintf(out, "%.9g %.9g\n", d->x.position[x], y);
        panel->line[line] = true;
        panel->low = fmin(panel->low, y);
        panel->high = fmax(panel->high, y);
    }
    fputs("END\n", out);
}

/* In gnuplot's single quotes only the single quote is special: it is doubled. */
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

/* The tics are the axis's values, or some of them if there are many. */
static void write_tics(char which, const struct chart_axis *axis, bool log, FILE *out)
{
    enum { MOST_TICS = 24 };
    double first = axis->position[0], last = first;
    size_t every = (axis->count + MOST_TICS - 1) / MOST_TICS;
    fprintf(out, "set %ctics (", which);
    for (size_t i = 0; i < axis->count; i++) {
        if (i % every == 0) {
            fputs(i ? ", " : "", out);
            write_quoted(axis->label[i], out);
            fprintf(out, " %.9g", axis->position[i]);
        }
        first = fmin(first, axis->position[i]);
        last = fmax(last, axis->position[i]);
    }
    fputs(")\n", out);
    double room = first == last ? 1 : (last - first) / 16;
    if (log && first > 0)
        fprintf(out, "set logscale %c\nset %crange [%.9g:%.9g]\n", which, which, first / 1.25, last * 1.25);
    else
        fprintf(out, "set %crange [%.9g:%.9g]\n", which, first - room, last + room);
}

static void write_frame(const struct picture *p, const struct chart_data *d, FILE *out)
{
    write_words("set xlabel ", *p->x_label ? p->x_label : p->x, out);
    write_words("set ylabel ", *p->y_label ? p->y_label : *p->best ? p->best : p->figure, out);
    fputs("set grid xtics ytics back lt 1 lw 0.6 lc rgb '#d8d8d8'\n"
          "set border 3\nset tics nomirror\n",
          out);
    write_tics('x', &d->x, p->log_x && d->x.numeric, out);
    if (*p->best)
        write_tics('y', &d->best, p->log_y && d->best.numeric, out);
}

/* Writes the tics of a logarithmic axis, close enough to read values by. */
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

/* Each panel has its own range. A range of less than a factor of two is always linear. */
static void write_range(const struct picture *c, const struct panel *panel, FILE *out)
{
    bool log = c->log_y && panel->low > 0 && panel->high >= 2 * panel->low;
    double room = (panel->high - panel->low) / 12 + (panel->high == panel->low);
    double low = log ? panel->low / 1.15 : panel->low - room,
           high = log ? panel->high * 1.15 : panel->high + room;
    if (*c->best)
        return; /* the range was set with the axis's tics */
    fputs(log ? "set logscale y\n" : "unset logscale y\nset ytics autofreq\n", out);
    if (log)
        write_log_tics(low, high, out);
    fprintf(out, "set yrange [%.9g:%.9g]\n", low, high);
}

static void write_panel(const struct picture *p, const struct chart_data *d, size_t number,
                        const struct panel *panel, FILE *out)
{
    static const char *const colours[] = {"#404040", "#c04000", "#0060ad", "#2e8b57",
                                          "#8b4fae", "#c8a000", "#d6629a", "#4fb0c6"};
    enum { COLOURS = sizeof colours / sizeof *colours };
    size_t lines = d->lines.count;
    char title[256];
    snprintf(title, sizeof title, "%s %s", p->panels, d->panels.label[number]);
    write_words("set title ", title, out);
    fputs(lines > 1 ? "set key bmargin center horizontal samplen 1.5 height 1.5\n" : "unset key\n", out);
    write_range(p, panel, out);
    const char *before = "plot";
    for (size_t line = 0; line < lines; line++) {
        if (!panel->line[line])
            continue;
        /* Later lines are thinner, so that lines that coincide are all visible. */
        double over = lines < 9 ? (double)(lines - line - 1) : 0;
        fprintf(out, "%s $d%zu_%zu with linespoints lw %.1f pt 7 ps %.2f lc rgb '%s' title ", before, number,
                line, 1.6 + 1.3 * over, 0.6 + 0.3 * over, colours[line % COLOURS]);
        write_quoted(d->lines.label[line], out);
        before = ",";
    }
    fputs("\n", out);
}

/* Writes all panels as an SVG or PNG picture. */
static void write_page(const struct picture *p, const struct chart_data *d, const struct panel panel[],
                       bool svg, const char *dir, FILE *out)
{
    size_t panels = d->panels.count;
    unsigned columns = panels < 4 ? (unsigned)panels : (unsigned)ceil(sqrt((double)panels));
    unsigned rows = ((unsigned)panels + columns - 1) / columns;
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.%s", dir, p->file, svg ? "svg" : "png");
    fprintf(out, "set terminal %s size %u,%u font 'Sans,%d'\n",
            svg ? "svg noenhanced background rgb 'white'" : "pngcairo noenhanced",
            panels == 1 ? 760 : 560 * columns, 400 * rows + 40, svg ? 12 : 10);
    write_words("set output ", path, out);
    fprintf(out, "set multiplot layout %u,%u title heading font ',13'\n", rows, columns);
    for (size_t i = 0; i < panels; i++)
        if (panel[i].high >= panel[i].low)
            write_panel(p, d, i, &panel[i], out);
    fputs("unset multiplot\n", out);
}

/* Writes the titles of the study and of the picture, and the values of the axes that the picture does not
 * use. */
static void write_heading(const struct record_points *points, const struct picture *p,
                          const struct chart_data *d, FILE *out)
{
    const char *study = json_string_value(json_object_get(points->header, "title"));
    const char *parts[] = {study ? study : "", p->title, d->fixed};
    char heading[512] = "";
    size_t used = 0;
    for (int i = 0; i < 3; i++)
        if (*parts[i] && used < sizeof heading)
            used +=
                (size_t)snprintf(heading + used, sizeof heading - used, "%s%s", used ? ": " : "", parts[i]);
    write_words("heading = ", heading, out);
}

static bool write_all(const struct record_points *points, const struct picture *p, const struct chart_data *d,
                      const char *dir, FILE *script, char **error)
{
    struct panel *panel = xcalloc(d->panels.count, sizeof *panel);
    bool any = false;
    for (size_t i = 0; i < d->panels.count; i++) {
        panel[i] = (struct panel){.low = INFINITY, .high = -INFINITY};
        for (size_t line = 0; line < d->lines.count; line++)
            write_line(d, i, line, &panel[i], script);
        any |= panel[i].high >= panel[i].low;
    }
    if (any) {
        write_heading(points, p, d, script);
        write_frame(p, d, script);
        write_page(p, d, panel, false, dir, script);
        write_page(p, d, panel, true, dir, script);
    } else {
        *error = xasprintf("no point has its figure, %s", p->figure);
    }
    free(panel);
    return any;
}

static bool write_script(const struct record_points *points, const struct picture *p, const char *dir,
                         FILE *script, char **error)
{
    struct chart_data d;
    bool ok = chart_data_take(points, p, &d, error) && write_all(points, p, &d, dir, script, error);
    chart_data_free(&d);
    return ok;
}

static bool run_gnuplot(const char *script, char **error)
{
    char *const argv[] = {"gnuplot", (char *)script, NULL};
    struct pool_job job = {.name = "the picture", .argv = argv};
    bool drawn = pool_run(&job, 1, 1, NULL).all_done;
    if (!drawn)
        *error = xstrdup(job.error ? job.error : "gnuplot was stopped");
    pool_clear(&job, 1);
    return drawn;
}

bool chart_draw(const struct record_points *points, const struct picture *p, const char *dir, char **error)
{
    struct scratch scratch = folder_scratch("touchstone-picture", error);
    if (!scratch.path)
        return false;
    char *path = xasprintf("%s/plot", scratch.path);
    FILE *script = fopen(path, "we");
    bool ok = script;
    if (!script)
        *error = xasprintf("%s cannot be written: %m", path);
    else
        ok = write_script(points, p, dir, script, error);
    if (script)
        fclose(script);
    ok = ok && run_gnuplot(path, error);
    scratch_remove(&scratch);
    free(path);
    return ok;
}

/* --- pictures for a study that names none --------------------------------------------------------------- */

static bool all_numbers(const json_t *values)
{
    size_t i;
    json_t *value;
    json_array_foreach(values, i, value) if (!json_is_number(value)) return false;
    return json_array_size(values) > 0;
}

/* Do the values span enough for a logarithmic axis? */
static bool is_wide(const json_t *values)
{
    double low = json_number_value(json_array_get(values, 0)), high = low;
    size_t i;
    json_t *value;
    json_array_foreach(values, i, value)
    {
        low = fmin(low, json_number_value(value));
        high = fmax(high, json_number_value(value));
    }
    return low > 0 && high >= 8 * low;
}

size_t chart_standard(const struct record_points *points, struct picture list[CHART_STANDARD])
{
    static const struct {
        const char *file, *title, *figure, *label;
        bool needs_nodes, log_y;
    } KINDS[CHART_STANDARD] = {
        {"time", "time", "time_s", "time, s", false, true},
        {"idle", "idle time", "idle_pct", "idle, % of all nodes' time", false, false},
        {"speedup", "speed-up against the fewest nodes", "speedup", "speed-up", true, true},
        {"speed_per_node", "speed per node", "speed_per_node", "speed per node", true, false}};
    json_t *axes = json_object_get(points->header, "axes"), *values;
    const char *name, *x = json_object_get(axes, "nodes") ? "nodes" : "", *lines = "", *panels = "";
    if (json_array_size(json_object_get(axes, "nodes")) < 2)
        x = "";
    json_object_foreach(axes, name, values) if (!*x && json_array_size(values) > 1 && all_numbers(values)) x =
        name;
    if (!*x)
        return 0;
    json_object_foreach(axes, name, values)
    {
        size_t count = json_array_size(values);
        if (count < 2 || strcmp(name, x) == 0)
            continue;
        if (!*lines && count <= CHART_MAX_LINES)
            lines = name;
        else if (!*panels && count <= CHART_MAX_PANELS)
            panels = name;
    }
    size_t count = strcmp(x, "nodes") == 0 ? CHART_STANDARD : 2;
    bool wide = is_wide(json_object_get(axes, x));
    for (size_t i = 0; i < count; i++)
        list[i] = (struct picture){.file = KINDS[i].file,
                                   .title = KINDS[i].title,
                                   .figure = KINDS[i].figure,
                                   .x = x,
                                   .lines = lines,
                                   .panels = panels,
                                   .best = "",
                                   .x_label = "",
                                   .y_label = KINDS[i].label,
                                   .log_x = wide,
                                   .log_y = KINDS[i].log_y && wide};
    return count;
}
