/* deadlock_command.c - touchstone deadlock: the report of a deadlock, as text, as a picture, as a page. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lab/commands/lab_commands.h"
#include "cli/options.h"
#include "cli/say.h"
#include "files/atomic_file.h"
#include "kernel/xalloc.h"
#include "lab/deadlock/deadlock_draw.h"
#include "lab/deadlock/deadlock_read.h"
#include "lab/page/page.h"

struct arguments {
    const char *out, *file;
};

static const struct argp_option OPTIONS[] = {
    {"output", 'o', "OUT", 0, "Write a picture, OUT.svg or OUT.png, or a page, OUT.html; default: text", 1},
    {0}};

static const char DOC[] =
    "Shows why the programs of a run wait for ever: who waits for whom, in which call and line, and for "
    "which cause. FILE is a report of touchstone run --deadlock, or results of touchstone run --json.\v"
    "Exit status:\n"
    "  0   the report is written\n"
    "  64  wrong arguments\n"
    "  65  FILE has no report of a deadlock, or OUT cannot be written\n\n"
    "Example:\n"
    "  touchstone run -n 4 --deadlock why.json prog\n"
    "  touchstone deadlock why.json -o why.svg";

static bool is_page(const char *path)
{
    size_t length = strlen(path);
    return length > 5 && !strcmp(path + length - 5, ".html");
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == 'o')
        a->out = arg;
    else if (key == ARGP_KEY_ARG && !a->file)
        a->file = arg;
    else if (key == ARGP_KEY_END && !a->file)
        argp_error(state, "which report is to be shown?");
    else if (key != ARGP_KEY_END)
        return ARGP_ERR_UNKNOWN;
    if (key == 'o' && !is_page(arg) && picture_kind_of(arg) != PICTURE_PNG &&
        picture_kind_of(arg) != PICTURE_SVG)
        argp_error(state, "-o %s: the name must end in .svg, .png or .html", arg);
    return 0;
}

static bool write_page(const struct arguments *a, char **error)
{
    struct atomic_file f;
    struct page *p = page_new();
    bool ok = page_add(p, a->file, NULL, error) && atomic_file_begin(&f, a->out, error);
    if (ok) {
        page_write(p, NULL, f.out);
        ok = atomic_file_end(&f, error);
    }
    page_free(p);
    return ok;
}

static bool show(const struct arguments *a, const struct waitfor *w, char **error)
{
    if (a->out && is_page(a->out))
        return write_page(a, error);
    if (a->out)
        return deadlock_draw_file(w, a->out, picture_kind_of(a->out), error);
    waitfor_write_text(w, stdout);
    printf("\n");
    return true;
}

int cli_deadlock(int argc, char **argv)
{
    static const struct argp ARGP = {OPTIONS, parse, "FILE", DOC, NULL, NULL, NULL};
    struct arguments a = {0};
    char *error = NULL;
    cli_parse(&ARGP, "touchstone deadlock", 0, argc, argv, &a);
    struct waitfor *w = deadlock_read(a.file, &error);
    bool ok = w && show(&a, w, &error);
    if (!ok)
        cli_say_error("deadlock", "%s", error);
    free(error);
    if (w)
        waitfor_free(w);
    canvas_forget_fonts();
    return ok ? 0 : CLI_EXIT_INPUT;
}
