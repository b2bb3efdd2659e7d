/* chart.c - see chart.h. */
#include "files/folder_make.h"
#include "kernel/xalloc.h"
#include "lab/chart/chart_script.h"
#include "lab/jobs/process_pool.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- a picture ------------------------------------------------------------------------------------------ */

static bool write_script(const struct record_points *points, const struct picture *p, const char *dir,
                         FILE *script, char **error)
{
    struct chart_data d;
    bool ok = chart_data_take(points, p, &d, error);
    if (ok && !chart_script_write(points->header, p, &d, dir, script)) {
        *error = record_no_figure(points, p->figure);
        ok = false;
    }
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

/* Does the file end so? */
static bool ends_with(const char *path, const char *end, size_t length)
{
    char last[16];
    FILE *f = fopen(path, "re");
    bool ends = f && fseek(f, -(long)length, SEEK_END) == 0 && fread(last, 1, length, f) == length &&
                memcmp(last, end, length) == 0;
    if (f)
        fclose(f);
    return ends;
}

/* gnuplot reports no failure when the disk is full: a picture that lacks its end is taken away. */
static bool is_whole(const char *dir, const char *file, char **error)
{
    static const char PNG_END[] = "IEND\xae\x42\x60\x82", SVG_END[] = "</svg>\n\n";
    char *png = xasprintf("%s/%s.png", dir, file), *svg = xasprintf("%s/%s.svg", dir, file);
    bool png_ends = ends_with(png, PNG_END, sizeof PNG_END - 1),
         whole = png_ends && ends_with(svg, SVG_END, sizeof SVG_END - 1);
    if (!whole) {
        *error = xasprintf("%s cannot be written whole: is the disk full?", png_ends ? svg : png);
        remove(png);
        remove(svg);
    }
    free(png);
    free(svg);
    return whole;
}

bool chart_can_draw(char **error)
{
    char *const argv[] = {"gnuplot", "--version", NULL};
    struct pool_job job = {.name = "gnuplot", .argv = argv};
    bool can = pool_run(&job, 1, 1, NULL).all_done;
    if (!can)
        *error =
            xasprintf("pictures need gnuplot, which cannot be run here (%s): install it, in Debian as root: "
                      "apt install gnuplot-nox",
                      job.error ? job.error : "stopped");
    pool_clear(&job, 1);
    return can;
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
    ok = ok && run_gnuplot(path, error) && is_whole(dir, p->file, error);
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
        const char *file, *title, *figure;
        bool needs_nodes, log_y;
    } KINDS[CHART_STANDARD] = {{"time", "time", "time_s", false, true},
                               {"idle", "idle time", "idle_pct", false, false},
                               {"speedup", "speed-up", "speedup", true, true},
                               {"speed_per_node", "speed per node", "speed_per_node", true, false}};
    json_t *axes = json_object_get(points->header, "axes"), *values;
    const char *name, *x = json_object_get(axes, "nodes") ? "nodes" : "", *lines = "", *panels = "";
    if (json_array_size(json_object_get(axes, "nodes")) < 2)
        x = "";
    json_object_foreach(axes, name, values) if (!*x && json_array_size(values) > 1 && all_numbers(values)) x =
        name;
    json_object_foreach(axes, name, values) if (!*x && json_array_size(values) > 1) x = name;
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
    bool wide = all_numbers(json_object_get(axes, x)) && is_wide(json_object_get(axes, x));
    for (size_t i = 0; i < count; i++)
        list[i] = (struct picture){.file = KINDS[i].file,
                                   .title = KINDS[i].title,
                                   .figure = KINDS[i].figure,
                                   .x = x,
                                   .lines = lines,
                                   .panels = panels,
                                   .best = "",
                                   .ratio = "",
                                   .lines_label = "",
                                   .panels_label = "",
                                   .x_label = "",
                                   .y_label = "",
                                   .log_x = wide,
                                   .log_y = KINDS[i].log_y && wide};
    return count;
}
