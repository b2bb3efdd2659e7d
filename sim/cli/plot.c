/* plot.c - touchstone plot: pictures of a study, from its results alone. */
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "cli/cli.h"
#include "lab/chart/chart.h"
#include "files/folder_make.h"
#include "lab/study/spec_read.h"
#include "kernel/xalloc.h"

static const char HELP[] =
    "usage: touchstone plot DIR|results.json [-o DIR] [options]\n"
    "\n"
    "Draws pictures of a study's results by gnuplot, as PNG and SVG: time, idle time, speed-up and speed per node against\n"
    "nodes (or the first axis of numbers), one line for each value of the next axis.\n"
    "\n"
    "  -o, --output DIR       where the pictures go; default where the results are\n"
    "      --study FILE       draw the pictures that this study file names\n"
    "\n"
    "One picture of your own:\n"
    "      --x AXIS           what it is drawn against\n"
    "      --y FIGURE         a figure of the results; any column of results.csv\n"
    "      --lines AXIS       one line for each value of that axis\n"
    "      --panels AXIS      one panel for each\n"
    "      --best AXIS        draw, instead of the figure, the value of that axis at which it is least\n"
    "      --logarithmic xy   x, y or both\n"
    "      --title TEXT, --x-label TEXT, --y-label TEXT\n"
    "      --file NAME        NAME.png and NAME.svg; default the figure's name\n"
    "\n"
    "Axes that have no place in a picture stand at their first value, and the picture says so.\n"
    "\n"
    "Exit status: 0 all is drawn; 1 a picture failed; 64 wrong arguments; 65 the results cannot be used.\n";

enum { EXIT_INPUT = 65 };

struct arguments {
    const char *results, *dir, *study;
    struct picture picture;
    bool help;
};

static int parse(int argc, char **argv, struct arguments *a)
{
    enum { STUDY = 256, X, Y, LINES, PANELS, BEST, LOGARITHMIC, TITLE, X_LABEL, Y_LABEL, FILE_NAME };
    static const struct option LONG[] = {{"output", required_argument, NULL, 'o'},
                                         {"study", required_argument, NULL, STUDY},
                                         {"x", required_argument, NULL, X},
                                         {"y", required_argument, NULL, Y},
                                         {"lines", required_argument, NULL, LINES},
                                         {"panels", required_argument, NULL, PANELS},
                                         {"best", required_argument, NULL, BEST},
                                         {"logarithmic", required_argument, NULL, LOGARITHMIC},
                                         {"title", required_argument, NULL, TITLE},
                                         {"x-label", required_argument, NULL, X_LABEL},
                                         {"y-label", required_argument, NULL, Y_LABEL},
                                         {"file", required_argument, NULL, FILE_NAME},
                                         {"help", no_argument, NULL, 'h'},
                                         {0}};
    struct picture *p = &a->picture;
    *a = (struct arguments){.picture = {"", "", "", "", "", "", "", "", "", false, false}};
    const char **const texts[] = {[X - X] = &p->x,
                                  [Y - X] = &p->figure,
                                  [LINES - X] = &p->lines,
                                  [PANELS - X] = &p->panels,
                                  [BEST - X] = &p->best,
                                  [TITLE - X] = &p->title,
                                  [X_LABEL - X] = &p->x_label,
                                  [Y_LABEL - X] = &p->y_label,
                                  [FILE_NAME - X] = &p->file};
    optind = 0;
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, ":o:h", LONG, NULL)) != -1;) {
        if (c == 'o') {
            a->dir = optarg;
        } else if (c == STUDY) {
            a->study = optarg;
        } else if (c == 'h') {
            a->help = true;
            return 0;
        } else if (c == LOGARITHMIC) {
            if (!*optarg || optarg[strspn(optarg, "xy")])
                return cli_usage("plot", "--logarithmic takes x, y or xy, not '%s'", optarg);
            p->log_x = strchr(optarg, 'x');
            p->log_y = strchr(optarg, 'y');
        } else if (c >= X && c <= FILE_NAME) {
            *texts[c - X] = optarg;
        } else if (c == ':') {
            return cli_usage("plot", "%s needs a value", argv[optind - 1]);
        } else {
            return cli_usage("plot", "there is no option %s", argv[optind - 1]);
        }
    }
    if (optind == argc)
        return cli_usage("plot",
                         "which results? (a folder that touchstone study wrote, or its results.json)");
    a->results = argv[optind++];
    if (optind < argc)
        return cli_usage("plot", "'%s' is one argument too many", argv[optind]);
    if (*p->x ? !*p->figure : *p->figure || *p->lines || *p->panels || *p->best)
        return cli_usage("plot", "a picture of your own needs both --x and --y");
    if (*p->file && !spec_is_name(p->file))
        return cli_usage("plot", "--file takes letters, digits, _ - and ., not '%s'", p->file);
    return 0;
}

/* DIR/results.json for a folder; malloc'd, as *dir, where pictures go by default. */
static char *results_path(const char *given, char **dir)
{
    struct stat st;
    const char *slash = strrchr(given, '/');
    if (stat(given, &st) == 0 && S_ISDIR(st.st_mode)) {
        *dir = xasprintf("%s", given);
        return xasprintf("%s/results.json", given);
    }
    *dir = slash ? xasprintf("%.*s", (int)(slash - given) + (slash == given), given) : xasprintf(".");
    return xasprintf("%s", given);
}

/* The number of pictures drawn; failures are said. */
static size_t draw(const struct record_points *points, const struct picture list[], size_t count,
                   const char *dir)
{
    size_t drawn = 0;
    for (size_t i = 0; i < count; i++) {
        char *error = NULL;
        if (chart_draw(points, &list[i], dir, &error)) {
            drawn++;
            printf("%s/%s.png and .svg\n", dir, list[i].file);
        } else {
            fprintf(stderr, "touchstone plot: no picture %s: %s\n", list[i].file, error);
        }
        free(error);
    }
    return drawn;
}

static int input_error(char *error)
{
    fprintf(stderr, "touchstone plot: %s\n", error);
    free(error);
    return EXIT_INPUT;
}

/* The pictures that are asked for, or those of the study file, or the standard ones. */
static int plot(struct arguments *a, const struct record_points *points, const char *dir)
{
    struct picture standard[CHART_STANDARD];
    char *error = NULL;
    if (*a->picture.x) {
        if (!*a->picture.file)
            a->picture.file = spec_is_name(a->picture.figure) ? a->picture.figure : "picture";
        return draw(points, &a->picture, 1, dir) == 1 ? 0 : 1;
    }
    if (a->study) {
        struct spec *s = spec_read(a->study, &error);
        if (!s)
            return input_error(error);
        bool all = draw(points, s->pictures, s->picture_count, dir) == s->picture_count;
        spec_free(s);
        return all ? 0 : 1;
    }
    size_t count = chart_standard(points, standard);
    if (!count)
        return input_error(xasprintf("no axis of several numbers: say what to draw with --x and --y"));
    return draw(points, standard, count, dir) == count ? 0 : 1;
}

int cli_plot(int argc, char **argv)
{
    struct arguments a;
    struct record_points points;
    char *error = NULL, *beside;
    int status = parse(argc, argv, &a);
    if (status)
        return status;
    if (a.help)
        return fputs(HELP, stdout), 0;
    char *path = results_path(a.results, &beside);
    const char *dir = a.dir ? a.dir : beside;
    if (!record_read(path, &points, &error)) {
        status = input_error(error);
    } else {
        status =
            folder_make(dir) ? plot(&a, &points, dir) : input_error(xasprintf("%s cannot be made: %m", dir));
        record_free(&points);
    }
    free(path);
    free(beside);
    return status;
}
