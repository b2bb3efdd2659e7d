/* page_command.c - touchstone page: results as one HTML file. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "lab/commands/lab_commands.h"
#include "cli/options.h"
#include "cli/say.h"
#include "cli/trace_options.h"
#include "files/atomic_file.h"
#include "kernel/xalloc.h"
#include "lab/page/page.h"
#include "lab/serve/live_study.h"

struct arguments {
    const char *out, *title;
    char **inputs; /* of main's argv */
    size_t count;
    struct trace_selection select;
};

static const struct argp_option OPTIONS[] = {{"title", CLI_TEXT(arguments, title), "TEXT", 0,
                                              "Heading of the page; default the name of what it shows", 1},
                                             {0}};

static const char DOC[] =
    "Writes OUT.html, one HTML file that shows the inputs in any browser: it holds all its data and scripts "
    "and fetches nothing, so it can be mailed or archived. OUT.html may be - for standard output.\v"
    "An input is recognised by what it holds:\n"
    "  run.json           touchstone run --json: where each node's time went, and a\n"
    "                     deadlock\n"
    "  run.trace          touchstone run --trace: timeline, messages, channels\n"
    "  why-not.json       touchstone run --deadlock: who waits for whom\n"
    "  profile.json       touchstone run --profile: time by function\n"
    "  out/groups         a folder of touchstone study, or its results.json: curves\n"
    "  out                a folder of touchstone tables, or its tables.json\n"
    "  why.json           touchstone trace why --json: the critical path\n"
    "  stacks.folded      folded stacks: a flame graph\n"
    "  head.ply           a surface, to be turned; several are seen together\n\n"
    "Exit status:\n"
    "  0   the page is written\n"
    "  64  wrong arguments\n"
    "  65  an input cannot be used, or the page not written\n\n"
    "Example:\n"
    "  touchstone run -n 16 --json run.json --trace run.trace prog\n"
    "  touchstone page run.html run.json run.trace";

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_INIT)
        state->child_inputs[0] = &a->select;
    else if (key == ARGP_KEY_ARG && !a->out)
        a->out = arg;
    else if (key == ARGP_KEY_ARG)
        a->inputs = xreallocarray(a->inputs, a->count + 1, sizeof *a->inputs), a->inputs[a->count++] = arg;
    else if (key == ARGP_KEY_END && !a->out)
        argp_error(state, "which page is to be written, and of what?");
    else if (key == ARGP_KEY_END && !a->count)
        argp_error(state, "what is %s to show? (touchstone page OUT.html INPUT...)", a->out);
    else
        return cli_store(key, arg, state);
    return 0;
}

/* May the page be written there? A folder, or a file that is no page, is most likely an input, and OUT.html
 * was forgotten or comes later. */
static bool is_free(const char *path, char **error)
{
    static const char DOCTYPE[] = "<!doctype html>";
    char head[sizeof DOCTYPE] = "";
    struct stat st;
    bool there = stat(path, &st) == 0;
    if (there && S_ISDIR(st.st_mode)) {
        *error = xasprintf("%s is a folder: the first argument is the page to be written", path);
        return false;
    }
    if (!there || !S_ISREG(st.st_mode) || st.st_size == 0)
        return true;
    FILE *in = fopen(path, "re");
    size_t size = in ? fread(head, 1, sizeof DOCTYPE - 1, in) : 0;
    if (in)
        fclose(in);
    if (size == sizeof DOCTYPE - 1 && strcasecmp(head, DOCTYPE) == 0)
        return true;
    *error = xasprintf("%s is there, and is no page: the first argument is the page to be written", path);
    return false;
}

/* Adds a trace, or a study with the points that a served page has added to it. */
static bool add_input(struct page *p, const char *path, const struct trace_selection *select, char **error)
{
    json_t *results = live_study_results_with_added(path);
    if (!results)
        return page_add(p, path, select, error);
    page_add_study(p, path, results);
    return true;
}

static bool add_inputs(struct page *p, const struct arguments *a, char **error)
{
    for (size_t i = 0; i < a->count; i++)
        if (!add_input(p, a->inputs[i], &a->select, error))
            return false;
    if ((a->select.nodes || a->select.from || a->select.to) && !page_has_trace(p)) {
        *error = xasprintf("--nodes, --from and --to say what of traces, and no input is one");
        return false;
    }
    return true;
}

static bool write_file(const struct page *p, const struct arguments *a, char **error)
{
    struct atomic_file f;
    if (!atomic_file_begin(&f, a->out, error))
        return false;
    page_write(p, a->title, f.out);
    return atomic_file_end(&f, error);
}

int cli_page(int argc, char **argv)
{
    static const struct argp_child CHILDREN[] = {{&CLI_TRACE_SELECTION, 0, "What of traces:", 2}, {0}};
    static const struct argp ARGP = {OPTIONS, parse, "OUT.html INPUT...", DOC, CHILDREN, NULL, NULL};
    struct arguments a = {0};
    char *error = NULL;
    cli_parse(&ARGP, "touchstone page", 0, argc, argv, &a);
    atomic_file_drop_at_signals();
    struct page *p = page_new();
    bool ok = is_free(a.out, &error) && add_inputs(p, &a, &error) && write_file(p, &a, &error);
    if (!ok)
        cli_say_error("page", "%s", error);
    else if (strcmp(a.out, "-"))
        fprintf(stderr, "%s: open it in a browser\n", a.out);
    free(error);
    page_free(p);
    free((bool *)(uintptr_t)a.select.nodes);
    free(a.inputs);
    return ok ? 0 : CLI_EXIT_INPUT;
}
