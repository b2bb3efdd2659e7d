/* trace_export_command.c - touchstone trace export: a trace in the format of another tool. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "lab/commands/lab_commands.h"
#include "lab/commands/trace_warning.h"
#include "cli/say.h"
#include "cli/trace_options.h"
#include "files/atomic_file.h"
#include "kernel/xalloc.h"
#include "lab/export/export.h"

enum { TABLE = CLI_KEY };

struct arguments {
    const char *trace;
    struct trace_selection select;
    struct export_request request; /* format EXPORT_FORMATS: not said */
};

static const struct argp_option OPTIONS[] = {
    {"format", 'f', "json|paje|otf2|picl|csv", 0, "The format; default by the ending of OUT", 1},
    {"output", 'o', "OUT", 0, "File to write (a folder for otf2); default standard output", 1},
    {"table", TABLE, "pieces|calls|waits|handlers|systems|messages|blocks", 0,
     "The table of csv; default OUT-pieces.csv "
     "and OUT-messages.csv",
     1},
    {0}};

static const char DOC[] = "Writes a trace in the format of another tool. All times keep each picosecond.\n\n"
                          "  json   NAME.json: open in ui.perfetto.dev, or chrome://tracing\n"
                          "  paje   NAME.paje: for pajeng (pj_dump, pj_gantt) and ViTE\n"
                          "  otf2   NAME.otf2, a folder: open its traces.otf2 in Vampir; otf2-print\n"
                          "  picl   NAME.picl, NAME.trf: for ParaGraph\n"
                          "  csv    NAME.csv: tables, for a spreadsheet or a program of your own\v"
                          "Tables of csv:\n"
                          "  pieces    of each node's time: computing, in a call, waiting, in the system\n"
                          "  calls     of NX, with their place in the program\n"
                          "  waits     in calls, and what for\n"
                          "  handlers  that interrupted a program\n"
                          "  systems   what the operating system did for messages meanwhile\n"
                          "  messages  with the times of all their steps\n"
                          "  blocks    waits of messages for channels\n\n"
                          "Exit status:\n"
                          "  0   all is written\n"
                          "  1   a file could not be written\n"
                          "  64  wrong arguments\n"
                          "  65  the trace cannot be used\n\n"
                          "Examples:\n"
                          "  touchstone trace export -o ring.json ring.trace\n"
                          "  touchstone trace export -f csv --table waits --nodes 0-7 ring.trace";

static void set_format(struct argp_state *state, struct export_request *r, const char *name)
{
    r->format = export_format_named(name);
    if (r->format == EXPORT_FORMATS)
        argp_error(state, "--format takes json, paje, otf2, picl or csv, not '%s'", name);
}

static void set_table(struct argp_state *state, struct export_request *r, const char *name)
{
    r->table = export_table_named(name);
    if (r->table == EXPORT_TABLES)
        argp_error(state,
                   "--table takes pieces, calls, waits, handlers, systems, messages or blocks, not '%s'",
                   name);
}

static void check(struct argp_state *state, struct export_request *r)
{
    bool to_file = strcmp(r->out, "-") != 0;
    if (r->format == EXPORT_FORMATS && to_file)
        r->format = export_format_of_file(r->out);
    if (r->format == EXPORT_FORMATS)
        argp_error(state,
                   "which format? say --format json, paje, otf2, picl or csv, or --output with a name that "
                   "ends in .json, .paje, .otf2, .picl or .csv");
    if (r->table != EXPORT_TABLES && r->format != EXPORT_CSV)
        argp_error(state, "--table is for --format csv");
    if (r->format == EXPORT_OTF2 && !to_file)
        argp_error(state, "otf2 is a folder: say --output OUT");
    if (r->format == EXPORT_CSV && r->table == EXPORT_TABLES && !to_file)
        argp_error(state,
                   "standard output takes one table: say --table pieces, messages ..., or --output OUT.csv");
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_INIT)
        state->child_inputs[0] = &a->select;
    else if (key == 'f')
        set_format(state, &a->request, arg);
    else if (key == 'o')
        a->request.out = arg;
    else if (key == TABLE)
        set_table(state, &a->request, arg);
    else if (key == ARGP_KEY_ARG)
        return cli_store_only(&a->trace, arg);
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "which trace? (written by touchstone run --trace FILE)");
    else if (key == ARGP_KEY_END)
        check(state, &a->request);
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

static int failed(int status, char *error)
{
    return cli_failed("trace export", error, status);
}

/* Is one of the files to write the trace itself? */
static bool is_trace(const char *trace, char *const files[])
{
    struct stat a, b;
    for (; *files; files++)
        if (stat(trace, &a) == 0 && stat(*files, &b) == 0 && a.st_dev == b.st_dev && a.st_ino == b.st_ino)
            return true;
    return false;
}

static int write_trace(const struct arguments *a)
{
    char *error = NULL;
    if (a->request.progress)
        cli_say_doing("reading", a->trace);
    struct trace *t = trace_load(a->trace, &a->select, &error);
    if (a->request.progress)
        cli_say_done();
    if (!t)
        return failed(CLI_EXIT_INPUT, error);
    if (!t->complete)
        cli_say_warning("trace export", "%s ends early: its run was stopped", a->trace);
    cli_trace_warn("trace export", t, a->trace);
    bool ok = export_write(t, &a->request, &error);
    trace_free(t);
    return ok ? 0 : failed(1, error);
}

int cli_trace_export(int argc, char **argv)
{
    static const struct argp_child CHILDREN[] = {{&CLI_TRACE_SELECTION, 0, "A part of the trace:", 2}, {0}};
    static const struct argp ARGP = {OPTIONS, parse, "TRACE", DOC, CHILDREN, NULL, NULL};
    struct arguments a = {.request = {EXPORT_FORMATS, EXPORT_TABLES, "-", NULL}};
    cli_parse(&ARGP, "touchstone trace export", 0, argc, argv, &a);
    if (isatty(STDERR_FILENO) && (strcmp(a.request.out, "-") != 0 || !isatty(STDOUT_FILENO)))
        a.request.progress = stderr;
    atomic_file_drop_at_signals();
    char **files = export_files(&a.request);
    int status = is_trace(a.trace, files)
                     ? failed(CLI_EXIT_INPUT, xasprintf("%s is the trace itself: name another file", a.trace))
                     : write_trace(&a);
    for (char **f = files; *f; f++)
        free(*f);
    free(files);
    free((bool *)(uintptr_t)a.select.nodes);
    return status;
}
