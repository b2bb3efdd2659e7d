/* plot_command.c - touchstone plot: pictures of a study, from its results alone. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "lab/commands/lab_commands.h"
#include "cli/options.h"
#include "cli/say.h"
#include "files/folder_make.h"
#include "kernel/xalloc.h"
#include "lab/chart/chart.h"
#include "lab/chart/speedup.h"
#include "files/words.h"
#include "lab/study/spec.h"
#include "lab/study/spec_read.h"

enum { LOGARITHMIC = CLI_KEY, BASELINE };

struct arguments {
    const char *results, *dir, *study;
    struct picture picture;
    char **baseline;
};

static const struct argp_option OPTIONS[] = {
    {"output", 'o', "DIR", 0, "Folder for the pictures; default the folder of the results", 1},
    {"study", CLI_TEXT(arguments, study), "FILE", 0,
     "Draw the pictures that this study file names, with its baseline", 1},
    {"baseline", BASELINE, "AXIS[=VALUE]", 0,
     "Speed-ups against the point of that value, or of a baseline for each value of the axis; may be given "
     "several times",
     1},
    {NULL, 0, NULL, 0, "One picture of your own:", 2},
    {"x", CLI_TEXT(arguments, picture.x), "AXIS", 0, "Axis of the study for the horizontal axis", 0},
    {"y", CLI_TEXT(arguments, picture.figure), "FIGURE", 0,
     "Figure of the results, any column of results.csv", 0},
    {"lines", CLI_TEXT(arguments, picture.lines), "AXIS", 0, "One line for each value of that axis", 0},
    {"panels", CLI_TEXT(arguments, picture.panels), "AXIS", 0, "One panel for each value of that axis", 0},
    {"best", CLI_TEXT(arguments, picture.best), "AXIS", 0,
     "Draw the value of that axis at which the figure is least", 0},
    {"ratio", CLI_TEXT(arguments, picture.ratio), "AXIS", 0,
     "Draw the figure at the second value of that axis divided by the figure at its first", 0},
    {"logarithmic", LOGARITHMIC, "x|y|xy", 0, "Logarithmic scale on x, y or xy", 0},
    {"own-ranges", CLI_FLAG(arguments, picture.own_ranges), NULL, 0,
     "A range of y for each panel; default the same for all", 0},
    {"title", CLI_TEXT(arguments, picture.title), "TEXT", 0, "Title of the picture", 0},
    {"x-label", CLI_TEXT(arguments, picture.x_label), "TEXT", 0, "Label of the horizontal axis", 0},
    {"y-label", CLI_TEXT(arguments, picture.y_label), "TEXT", 0, "Label of the vertical axis", 0},
    {"lines-label", CLI_TEXT(arguments, picture.lines_label), "TEXT", 0, "Title of the legend", 0},
    {"panels-label", CLI_TEXT(arguments, picture.panels_label), "TEXT", 0,
     "What the panels' titles begin with; default the axis's name", 0},
    {"file", CLI_TEXT(arguments, picture.file), "NAME", 0,
     "Write NAME.png and NAME.svg; default the figure's name", 0},
    {0}};

static const char DOC[] =
    "Draws pictures of a study's results by gnuplot, as PNG and SVG: time, idle time, speed-up and speed "
    "per node against nodes (or the first axis of numbers), one line for each value of the next axis.\v"
    "An axis that no option names is fixed at its first value, and the picture says so.\n\n"
    "Speed-up and speed per node compare all points with one baseline: the fewest nodes, and of these the "
    "least time. --baseline scheme=simple takes it among the points of that scheme; --baseline image takes "
    "one for each image. Without --baseline they are as the study wrote them.\n\n"
    "Exit status:\n"
    "  0   all pictures are drawn\n"
    "  1   a picture failed\n"
    "  64  wrong arguments\n"
    "  65  the results cannot be used\n\n"
    "Example:\n"
    "  touchstone plot out/groups --x nodes --y idle_pct --lines group";

/* Does an option say something of a picture of the user's own? */
static bool is_own(const struct picture *p)
{
    const char *const texts[] = {p->x,     p->figure,  p->lines,   p->panels,      p->best,         p->ratio,
                                 p->title, p->x_label, p->y_label, p->lines_label, p->panels_label, p->file};
    bool any = p->log_x || p->log_y || p->own_ranges;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        any |= *texts[i] != '\0';
    return any;
}

static void check(struct argp_state *state, const struct arguments *a)
{
    const struct picture *p = &a->picture;
    if (is_own(p) && a->study)
        argp_error(state, "--study draws that file's pictures, and no picture of your own beside them");
    if (is_own(p) && (!*p->x || !*p->figure))
        argp_error(state, "a picture of your own needs both --x and --y");
    if (*p->best && *p->ratio)
        argp_error(state, "--ratio cannot be drawn of the --best");
    if (*p->file && !spec_is_name(p->file))
        argp_error(state, "--file takes letters, digits, _ - and ., not '%s'", p->file);
}

static void set_scales(struct argp_state *state, struct picture *p, const char *axes)
{
    if (!*axes || axes[strspn(axes, "xy")])
        argp_error(state, "--logarithmic takes x, y or xy, not '%s'", axes);
    p->log_x = strchr(axes, 'x');
    p->log_y = strchr(axes, 'y');
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == 'o')
        a->dir = arg;
    else if (key == LOGARITHMIC)
        set_scales(state, &a->picture, arg);
    else if (key == BASELINE)
        words_add(&a->baseline, xstrdup(arg));
    else if (key == ARGP_KEY_ARG)
        return cli_store_only(&a->results, arg);
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "which results? (a folder that touchstone study wrote, or its results.json)");
    else if (key == ARGP_KEY_END)
        check(state, a);
    else
        return cli_store(key, arg, state);
    return 0;
}

/* The path of results.json, in the given folder or the given file itself; *dir is the default folder of
 * the pictures. Both are malloc'd. */
static char *results_path(const char *given, char **dir)
{
    struct stat st;
    const char *slash = strrchr(given, '/');
    if (stat(given, &st) == 0 && S_ISDIR(st.st_mode)) {
        *dir = xstrdup(given);
        return xasprintf("%s/results.json", given);
    }
    *dir = slash ? xasprintf("%.*s", (int)(slash - given) + (slash == given), given) : xstrdup(".");
    return xstrdup(given);
}

/* Returns the number of pictures drawn; reports the others' errors. */
static size_t draw(const struct record_points *points, const struct picture list[], size_t count,
                   const char *dir)
{
    size_t drawn = 0;
    char *missing = NULL;
    if (!chart_can_draw(&missing)) {
        cli_failed("plot", missing, 1);
        return 0;
    }
    for (size_t i = 0; i < count; i++) {
        char *error = NULL;
        if (chart_draw(points, &list[i], dir, &error)) {
            drawn++;
            printf("%s/%s.png and .svg\n", dir, list[i].file);
        } else {
            cli_say_error("plot", "no picture %s: %s", list[i].file, error);
        }
        free(error);
    }
    return drawn;
}

static int input_error(char *error)
{
    return cli_failed("plot", error, CLI_EXIT_INPUT);
}

/* Draws the pictures that the study file names, with its baseline unless the options give one. */
static int plot_study(const struct arguments *a, struct record_points *points, const char *dir)
{
    char *error = NULL;
    struct spec *s = spec_read(a->study, &error);
    if (!s)
        return input_error(error);
    int status;
    if (s->baseline && !a->baseline && !speedup_renew(points, s->baseline, &error))
        status = input_error(error);
    else
        status = draw(points, s->pictures, s->picture_count, dir) == s->picture_count ? 0 : 1;
    spec_free(s);
    return status;
}

/* Draws the picture of the options, or those of the study file, or the standard ones. */
static int plot(struct arguments *a, struct record_points *points, const char *dir)
{
    struct picture standard[CHART_STANDARD];
    if (*a->picture.x) {
        if (!*a->picture.file)
            a->picture.file = spec_is_name(a->picture.figure) ? a->picture.figure : "picture";
        return draw(points, &a->picture, 1, dir) == 1 ? 0 : 1;
    }
    if (a->study)
        return plot_study(a, points, dir);
    size_t count = chart_standard(points, standard);
    if (!count)
        return input_error(xasprintf("no axis of several values: say what to draw with --x and --y"));
    return draw(points, standard, count, dir) == count ? 0 : 1;
}

int cli_plot(int argc, char **argv)
{
    static const struct argp ARGP = {OPTIONS, parse, "DIR|results.json", DOC, NULL, NULL, NULL};
    struct arguments a = {.picture = {PICTURE_NO_TEXTS}};
    struct record_points points;
    char *error = NULL, *beside;
    cli_parse(&ARGP, "touchstone plot", 0, argc, argv, &a);
    char *path = results_path(a.results, &beside);
    const char *dir = a.dir ? a.dir : beside;
    int status;
    if (!record_read(path, &points, &error)) {
        status = input_error(error);
    } else {
        if (!folder_make(dir))
            status = input_error(xasprintf("%s cannot be made: %m", dir));
        else if (a.baseline && !speedup_renew(&points, (const char *const *)a.baseline, &error))
            status = input_error(error);
        else
            status = plot(&a, &points, dir);
        record_free(&points);
    }
    words_free(a.baseline);
    free(path);
    free(beside);
    return status;
}
