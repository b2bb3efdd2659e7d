/* trace_show_command.c - touchstone trace show: pictures of a run, from its trace. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "lab/commands/lab_commands.h"
#include "lab/commands/trace_warning.h"
#include "cli/say.h"
#include "cli/trace_options.h"
#include "files/atomic_file.h"
#include "files/folder_make.h"
#include "files/virtual_time.h"
#include "kernel/xalloc.h"
#include "lab/show/channel_film.h"
#include "lab/show/displays.h"
#include "lab/draw/picture_file.h"
#include "nx_api/contract/edit_distance.h"

enum { BY = CLI_KEY, MESSAGES, SCALE, FRAMES, SVG, THAN };

/* Options that only some displays obey. */
enum { BY_WHAT, HOW_MANY, SHARES_END, AMOUNTS_END, FRAME_COUNT, DISPLAY_OPTIONS };
static const struct {
    const char *option, *displays[2];
} OBEYED_BY[DISPLAY_OPTIONS] = {
    [BY_WHAT] = {"--by", {"matrix", "queues"}},
    [HOW_MANY] = {"--messages", {"space-time"}},
    [SHARES_END] = {"--scale with a share", {"channels", "film"}},
    [AMOUNTS_END] = {"--scale with a number", {"matrix"}},
    [FRAME_COUNT] = {"--frames", {"film"}},
};
enum { DEFAULT_FRAMES = 60, MOST_FRAMES = 1000, MOST_LINES = 1000000 };

/* A run to be drawn. */
struct run {
    const char *path;
    struct trace *trace;
    struct show show;
};

struct arguments {
    const char **names; /* displays, then the trace */
    size_t name_count;
    const char *output;
    bool svg, list;
    bool given[DISPLAY_OPTIONS];
    struct trace_selection select;
    const struct display **displays;
    size_t display_count;
    struct run run, other; /* other.path NULL: none is compared */
};

static const struct argp_option OPTIONS[] = {
    {"output", 'o', "OUT", 0,
     "OUT.png or OUT.svg (a film: OUT.webp) for one display, - for standard output; or a folder. Default: "
     "TRACE-DISPLAY.png beside the trace",
     1},
    {"svg", SVG, NULL, 0, "Write SVG where the name does not say it", 1},
    {"by", BY, "messages|bytes", 0, "Count messages or bytes, in matrix and queues; default messages", 1},
    {"messages", MESSAGES, "N", 0,
     "Draw at most N messages of the whole interval in space-time; default as many as leave it readable, and "
     "of a whole run where they are the densest",
     1},
    {"scale", SCALE, "END", 0,
     "The colours' scale ends there, so that pictures of two runs compare: 5% of the time for channels and "
     "film, 1000 messages or bytes for matrix. May be given for both",
     1},
    {"than", THAN, "OTHER", 0,
     "Draw the run of OTHER, a trace, above this run, with one scale of time, in gantt, space-time and "
     "utilisation",
     1},
    {"frames", FRAMES, "N", 0, "Pictures of a film; default 60", 1},
    {0}};

static const char DOC[] =
    "Draws what nodes, messages and channels did, from a trace of touchstone run --trace. DISPLAY is one or "
    "more of the following, or all; default gantt. `touchstone trace show list` says what to look for in "
    "each.";
static const char AFTER[] = "\vOf more than 128 nodes, neighbours share a row; a picture says how many.\n\n"
                            "Exit status:\n"
                            "  0   all pictures are drawn\n"
                            "  1   a picture failed\n"
                            "  64  wrong arguments\n"
                            "  65  the trace cannot be used\n\n"
                            "Example:\n"
                            "  touchstone run -m ipsc860 -n 16 --trace ring.trace ring\n"
                            "  touchstone trace show gantt space-time --from 1ms --to 2ms ring.trace\n"
                            "  touchstone trace show all -o pictures ring.trace\n"
                            "  touchstone trace show gantt --than before.trace after.trace";

/* --- arguments --- */

static void add_display(struct arguments *a, const struct display *d)
{
    a->displays = xreallocarray(a->displays, a->display_count + 1, sizeof(struct display *));
    a->displays[a->display_count++] = d;
}

static void no_such_display(struct argp_state *state, const char *name)
{
    struct edit_nearest n = {.meant = name};
    for (const struct display *d = DISPLAYS; d->name; d++)
        edit_see(&n, d->name);
    if (n.best)
        argp_error(state, "there is no display '%s'; did you mean '%s'?", name, n.best);
    else
        argp_error(state, "there is no display '%s'; `touchstone trace show list` has them all", name);
}

static void take_display(struct argp_state *state, struct arguments *a, const char *name)
{
    const struct display *d = display_find(name);
    if (!strcmp(name, "all"))
        for (d = DISPLAYS; d->name; d++) {
            if (!a->other.path || d->compares)
                add_display(a, d);
        }
    else if (d && a->other.path && !d->compares)
        argp_error(state, "--than draws gantt, space-time and utilisation, not '%s'", name);
    else if (d)
        add_display(a, d);
    else
        no_such_display(state, name);
}

/* A name that means a picture, and no folder. */
static bool is_of_another_kind(const char *output)
{
    static const char *const others[] = {".jpg", ".jpeg", ".gif", ".pdf", ".eps", ".ps", ".tif", ".bmp"};
    const char *dot = strrchr(output, '.');
    for (size_t i = 0; dot && i < sizeof others / sizeof *others; i++)
        if (!strcasecmp(dot, others[i]))
            return true;
    return false;
}

/* One file is for one display, and its name must be of a kind in which that is drawn. */
static void check_output(struct argp_state *state, const struct arguments *a)
{
    bool film = a->displays[0]->film, to_stdout = a->output && !strcmp(a->output, "-");
    enum picture_kind kind = a->output ? picture_kind_of(a->output) : PICTURE_UNKNOWN;
    if ((kind || to_stdout) && a->display_count > 1)
        argp_error(state, "-o %s is one file, for one display: give a folder for %zu", a->output,
                   a->display_count);
    if (kind && film != (kind == PICTURE_WEBP))
        argp_error(state,
                   film ? "the film is an animated WebP: -o OUT.webp, not '%s'"
                        : "pictures are PNG or SVG: -o OUT.png or OUT.svg, not '%s'",
                   a->output);
    if (a->output && is_of_another_kind(a->output))
        argp_error(state, "pictures are PNG or SVG: -o OUT.png, OUT.svg or a folder, not '%s'", a->output);
}

static bool is_obeyed(const struct arguments *a, int option)
{
    for (size_t i = 0; i < a->display_count; i++)
        for (int d = 0; d < 2 && OBEYED_BY[option].displays[d]; d++)
            if (!strcmp(a->displays[i]->name, OBEYED_BY[option].displays[d]))
                return true;
    return false;
}

static void check_options(struct argp_state *state, const struct arguments *a)
{
    for (int o = 0; o < DISPLAY_OPTIONS; o++) {
        const char *const *d = OBEYED_BY[o].displays;
        if (a->given[o] && !is_obeyed(a, o))
            argp_error(state, "%s is for %s%s%s, not for '%s'", OBEYED_BY[o].option, d[0],
                       d[1] ? " and " : "", d[1] ? d[1] : "", a->displays[0]->name);
    }
}

static void understand(struct argp_state *state, struct arguments *a)
{
    if (a->name_count == 1 && !strcmp(a->names[0], "list")) {
        a->list = true;
        return;
    }
    if (!a->name_count || (a->name_count == 1 && (display_find(a->names[0]) || !strcmp(a->names[0], "all"))))
        argp_error(state, "which trace? (written by touchstone run --trace FILE; it comes last)");
    a->run.path = a->names[a->name_count - 1];
    for (size_t i = 0; i + 1 < a->name_count; i++)
        take_display(state, a, a->names[i]);
    if (!a->display_count)
        add_display(a, display_find("gantt"));
    check_options(state, a);
    check_output(state, a);
}

/* "5%" ends the scale of shares, "1000" that of amounts. */
static void set_scale(struct argp_state *state, struct arguments *a, const char *arg)
{
    struct show *s = &a->run.show;
    char *end;
    double value = strtod(arg, &end);
    bool share = strcmp(end, "%") == 0;
    if (end == arg || (*end && !share) || !(value > 0) || value > (share ? 100 : 1e18))
        argp_error(state, "--scale takes a share such as 5%%, or a number such as 1000, not '%s'", arg);
    a->given[share ? SHARES_END : AMOUNTS_END] = true;
    *(share ? &s->most_share : &s->most_amount) = share ? value / 100 : value;
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_INIT) {
        state->child_inputs[0] = &a->select;
    } else if (key == ARGP_KEY_ARG) {
        a->names = xreallocarray(a->names, a->name_count + 1, sizeof(char *));
        a->names[a->name_count++] = arg;
    } else if (key == 'o') {
        a->output = arg;
    } else if (key == SVG) {
        a->svg = true;
    } else if (key == BY) {
        if (strcmp(arg, "messages") && strcmp(arg, "bytes"))
            argp_error(state, "--by takes messages or bytes, not '%s'", arg);
        a->given[BY_WHAT] = true;
        a->run.show.by_bytes = !strcmp(arg, "bytes");
    } else if (key == MESSAGES) {
        a->given[HOW_MANY] = true;
        a->run.show.most_lines = cli_whole(state, "--messages", "a number of messages", MOST_LINES, arg);
    } else if (key == SCALE) {
        set_scale(state, a, arg);
    } else if (key == THAN) {
        a->other.path = arg;
    } else if (key == FRAMES) {
        a->given[FRAME_COUNT] = true;
        a->run.show.frames = cli_whole(state, "--frames", "a number of pictures", MOST_FRAMES, arg);
    } else if (key == ARGP_KEY_END) {
        understand(state, a);
    } else {
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

/* --- drawing --- */

/* The file of a display. malloc'd. */
static char *path_of(const struct arguments *a, const struct display *d)
{
    const char *ending = d->film ? "webp" : a->svg ? "svg" : "png";
    if (a->output && (picture_kind_of(a->output) || !strcmp(a->output, "-")))
        return xstrdup(a->output);
    if (a->output)
        return xasprintf("%s%s%s.%s", a->output,
                         *a->output && a->output[strlen(a->output) - 1] == '/' ? "" : "/", d->name, ending);
    const char *path = strcmp(a->run.path, "-") ? a->run.path : "trace", *base = basename(path),
               *dot = strrchr(base, '.');
    size_t length = dot && dot > base ? (size_t)(dot - path) : strlen(path);
    return xasprintf("%.*s-%s%s.%s", (int)length, path, d->name, a->other.path ? "-than" : "", ending);
}

struct drawing {
    const struct display *display;
    const struct arguments *arguments;
};

static double height_of(const struct drawing *d)
{
    const struct arguments *a = d->arguments;
    return d->display->height(&a->run.show) + (a->other.path ? d->display->height(&a->other.show) : 0);
}

static void draw_display(void *ctx, const struct canvas *c)
{
    const struct drawing *d = ctx;
    const struct arguments *a = d->arguments;
    if (a->other.path) {
        d->display->draw(&a->other.show, c);
        cairo_translate(c->cr, 0, d->display->height(&a->other.show));
    }
    d->display->draw(&a->run.show, c);
}

/* On a terminal, says what takes its time, in a line that the next one rewrites; NULL erases it. */
static void stage(const char *doing, const char *what)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r\033[K%s%s", doing ? doing : "", doing ? what : "");
}

static void film_stage(uint32_t done, uint32_t of)
{
    char *text = xasprintf("picture %u of %u", done, of);
    stage("drawing film: ", text);
    free(text);
}

static bool write_display(const struct arguments *a, const struct display *d, const char *path, char **error)
{
    struct drawing drawing = {d, a};
    if (d->film)
        return channel_film_write(&a->run.show, path, film_stage, error);
    enum picture_kind kind = picture_kind_of(path);
    return picture_write(path,
                         kind     ? kind
                         : a->svg ? PICTURE_SVG
                                  : PICTURE_PNG,
                         height_of(&drawing), draw_display, &drawing, error);
}

/* Draws all displays; says what it has written. Returns the exit status. */
static int draw_all(const struct arguments *a)
{
    int status = 0;
    for (size_t i = 0; i < a->display_count; i++) {
        char *error = NULL, *path = path_of(a, a->displays[i]);
        stage("drawing ", a->displays[i]->name);
        bool written = write_display(a, a->displays[i], path, &error);
        stage(NULL, NULL);
        if (!written) {
            cli_say_error("trace show", "no picture %s: %s", a->displays[i]->name, error);
            free(error);
            status = 1;
        } else if (strcmp(path, "-")) {
            printf("%s\n", path);
        }
        free(path);
    }
    return status;
}

/* --- the runs --- */

static bool read_run(const struct arguments *a, struct run *r, char **error)
{
    stage("reading ", r->path);
    r->trace = trace_load(r->path, &a->select, error);
    stage(NULL, NULL);
    if (!r->trace)
        return false;
    cli_trace_warn("trace show", r->trace, r->path);
    r->show.trace = r->trace;
    r->show.densest = !a->select.from && !a->select.to && !r->show.most_lines && !a->other.path;
    r->show.label = a->other.path ? basename(r->path) : NULL;
    r->show.rows = node_rows_make(r->trace);
    return true;
}

static void forget_run(struct run *r)
{
    if (!r->trace)
        return;
    node_rows_free(&r->show.rows);
    trace_free(r->trace);
}

/* One scale of time: both runs are drawn to the end of the longer one, and from where both are traced. */
static void share_interval(struct trace *a, struct trace *b)
{
    a->from = b->from = vt_max(a->from, b->from);
    a->to = b->to = vt_max(a->to, b->to);
}

/* Is there anything to draw? */
static char *why_nothing(const struct run *r)
{
    const struct trace *t = r->trace;
    if (t->from >= vt_min(t->to, t->end))
        return xasprintf("%s has nothing in that interval: the run ended at %s", r->path,
                         virtual_time_moment(t->end).text);
    if (!r->show.rows.nodes)
        return xasprintf("%s has nothing of these nodes: they were not traced, or had no program", r->path);
    return NULL;
}

/* Reads the runs. Returns what is wrong, malloc'd. */
static char *read_runs(struct arguments *a)
{
    char *error = NULL;
    a->other.show = a->run.show; /* the options */
    if (!read_run(a, &a->run, &error))
        return error;
    if (!a->other.path)
        return why_nothing(&a->run);
    if (!read_run(a, &a->other, &error))
        return error;
    share_interval(a->run.trace, a->other.trace);
    error = why_nothing(&a->run);
    return error ? error : why_nothing(&a->other);
}

static int show(struct arguments *a)
{
    char *error = read_runs(a);
    bool folder = a->output && strcmp(a->output, "-") && !picture_kind_of(a->output);
    if (!error && folder && !folder_make(a->output))
        error = xasprintf("%s cannot be made: %m", a->output);
    int status = error ? cli_failed("trace show", error, CLI_EXIT_INPUT) : draw_all(a);
    forget_run(&a->run);
    forget_run(&a->other);
    return status;
}

static int list(void)
{
    for (const struct display *d = DISPLAYS; d->name; d++)
        printf("%-12s %s\n%-12s %s\n", d->name, d->what, "", d->look);
    return 0;
}

int cli_trace_show(int argc, char **argv)
{
    enum { LINES = 32 };
    struct argp_option options[LINES] = {0}, *line = options;
    for (const struct argp_option *o = OPTIONS; o->name; o++)
        *line++ = *o;
    *line++ = (struct argp_option){.doc = "Displays:", .group = 3};
    for (const struct display *d = DISPLAYS; d->name; d++)
        *line++ = (struct argp_option){.name = d->name, .doc = d->what, .flags = OPTION_DOC, .group = 3};
    static const struct argp_child CHILDREN[] = {{&CLI_TRACE_SELECTION, 0, NULL, 2}, {0}};
    char *doc = xasprintf("%s%s", DOC, AFTER);
    const struct argp argp = {options, parse, "[DISPLAY...] TRACE\nlist", doc, CHILDREN, NULL, NULL};
    struct arguments a = {.run.show.frames = DEFAULT_FRAMES};
    cli_parse(&argp, "touchstone trace show", 0, argc, argv, &a);
    atomic_file_drop_at_signals();
    int status = a.list ? list() : show(&a);
    canvas_forget_fonts();
    free((bool *)(uintptr_t)a.select.nodes);
    free(a.names);
    free(a.displays);
    free(doc);
    return status;
}
