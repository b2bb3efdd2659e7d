/* trace_why_command.c - touchstone trace why: what a run spent its time on. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lab/commands/lab_commands.h"
#include "lab/commands/trace_warning.h"
#include "cli/installation.h"
#include "cli/program_options.h"
#include "lab/commands/run_again.h"
#include "cli/say.h"
#include "cli/trace_options.h"
#include "files/atomic_file.h"
#include "kernel/xalloc.h"
#include "lab/why/rerun_changes.h"
#include "lab/why/why_json.h"
#include "lab/why/why_path_lines.h"
#include "lab/why/why_report.h"
#include "observe/json_file.h"

enum { TOP = CLI_KEY, SET, CPU, USUAL_TOP = 10 };

struct arguments {
    const char *path, *than, *output, *json;
    struct trace_selection select;
    uint32_t top;
    unsigned jobs;
    const char **set; /* ended by NULL */
    size_t set_count;
    double cpu;
    bool path_lines, rerun;
};

static const struct argp_option OPTIONS[] = {
    {NULL, 0, NULL, 0, "What to show:", 1},
    {"top", TOP, "N", 0, "Rows of each table; default 10", 0},
    {"path", CLI_FLAG(arguments, path_lines), NULL, 0,
     "Instead, show the critical path: a line for each of its steps", 0},
    {"than", CLI_TEXT(arguments, than), "OTHER", 0,
     "Compare with the critical path of another trace: the same program on fewer nodes, say", 0},
    {"json", CLI_TEXT(arguments, json), "FILE", 0,
     "Write JSON, too: all rows, times in picoseconds, with --path each step; '-' is standard output, which "
     "has no text then",
     0},
    {"output", 'o', "FILE", 0, "Write the text into FILE; default standard output", 0},
    {NULL, 0, NULL, 0, "What if (runs the program again; it writes its own files again, too):", 2},
    {"rerun", CLI_FLAG(arguments, rerun), NULL, 0,
     "Run again with interrupts, messages, calls, network, contention, disks or computing made free", 0},
    {"set", SET, "KEY=VALUE", 0,
     "Run again with a value for a key of the machine file, such as system.interrupt_us=0; may be repeated",
     0},
    {"cpu", CPU, "TIMES", 0, "Run again with processors that compute so many times faster", 0},
    {0}};

static const char DOC[] =
    "Says why a run took its time, in sentences and tables, from the trace that touchstone run --trace FILE "
    "wrote.\n\n"
    "The critical path leads from the end of the run back to its start: along a node's time, and where the "
    "node waited, along the message that ended the wait, to its sender. Its steps fill the time of the run. "
    "Only what is on the path can make the run shorter: its share is what a class of work can save at "
    "most.\n\n"
    "The waits of all nodes are divided by cause, to the picosecond: late sender (the message had not been "
    "sent), late receiver (a long message had to wait for its receive), channel busy, handler busy (the "
    "partner was in a handler), system: other messages (a processor was busy with these), disk, and the "
    "message's own way. With --nodes, only the waits of these nodes count.\v"
    "With --rerun, --set or --cpu the command of the trace runs again in its folder, with numbers of the "
    "machine changed: exact answers. First it runs unchanged; if it takes another time than the trace says, "
    "the program or its input has changed, and trace why stops. /cfs is a copy.\n\n"
    "Computing counts for the functions that the program called between two calls of NX, as stacks and code "
    "show; where several may have worked, all are named: 'force or main'. Where a handler interrupts the "
    "program, it counts for the function that is interrupted.\n\n"
    "Exit status:\n"
    "  0    done\n"
    "  64   wrong arguments\n"
    "  65   a trace cannot be used, or its command cannot be run again; or a re-run\n"
    "       failed: its row has no answer\n"
    "  74   the result cannot be written\n"
    "  128  and more: a re-run was stopped by the signal of that number less 128\n\n"
    "Example:\n"
    "  touchstone run -m delta -n 128 --trace slow.trace app/model -group 128\n"
    "  touchstone trace why slow.trace\n"
    "  touchstone trace why --rerun slow.trace";

static void set_cpu(struct argp_state *state, struct arguments *a, const char *text)
{
    a->cpu = cli_seconds(state, "--cpu", text);
    a->rerun = true;
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_INIT)
        state->child_inputs[0] = &a->select, state->child_inputs[1] = &a->jobs;
    else if (key == 'o')
        a->output = arg;
    else if (key == TOP)
        a->top = cli_whole(state, "--top", "a number of rows", UINT32_MAX, arg);
    else if (key == SET)
        cli_add_setting(state, a->set, &a->set_count, arg), a->rerun = true;
    else if (key == CPU)
        set_cpu(state, a, arg);
    else if (key == ARGP_KEY_ARG)
        return cli_store_only(&a->path, arg);
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "which trace? (written by touchstone run --trace FILE)");
    else
        return cli_store(key, arg, state);
    return 0;
}

static int failed(char *error, int status)
{
    return cli_failed("trace why", error, status);
}

/* The path needs all nodes: --nodes is for the waits. */
static struct why *why_of(const char *path, const struct trace_selection *select)
{
    char *error = NULL;
    struct trace *t =
        trace_load(path, &(struct trace_selection){.from = select->from, .to = select->to}, &error);
    if (t && t->to > t->from && trace_has_nodes(t, select, &error)) {
        cli_trace_warn("trace why", t, path);
        return why_new(t, select);
    }
    if (t && !error)
        error =
            xasprintf(t->end ? "%s: nothing of the run lies in that time" : "%s: the run took no time", path);
    failed(error, 0);
    trace_free(t);
    return NULL;
}

/* Runs the command of the trace again. Returns an exit status. */
static int run_again(const struct arguments *a, const struct trace *t, struct reruns *r)
{
    struct cli_installation places;
    char *error = NULL;
    if (!cli_find_installation(&places, "trace why"))
        return CLI_EXIT_INPUT;
    struct run_again again;
    if (!run_again_from(t, &places, &again, &error))
        return failed(error, CLI_EXIT_INPUT);
    if ((error = run_again_refuses(&again, &places, a->set))) {
        run_again_free(&again);
        return failed(error, argp_err_exit_status);
    }
    struct rerun_options o = {.command = again.command,
                              .cfg = again.cfg,
                              .set = a->set,
                              .cpu = a->cpu,
                              .at_once = cli_jobs(a->jobs),
                              .progress = stderr};
    bool ok = rerun_all(t, &o, r, &error);
    run_again_free(&again);
    return ok ? 0 : failed(error, r->stopped ? 128 + r->stopped : CLI_EXIT_INPUT);
}

static bool write_text(const struct arguments *a, struct why *w, const struct why_report_options *o,
                       char **error)
{
    struct atomic_file f;
    if (!atomic_file_begin(&f, a->output, error))
        return false;
    if (a->path_lines)
        why_path_lines(w, f.out);
    else
        why_report(w, o, f.out);
    return atomic_file_end(&f, error);
}

static int write_all(const struct arguments *a, struct why *w, const struct why_report_options *o)
{
    bool text = !a->json || strcmp(a->json, "-") != 0 || strcmp(a->output, "-") != 0;
    char *error = NULL;
    if (a->json) /* first: a reader of the text that has seen enough (| head) ends the process */
        error = json_file_write(why_json(w, o, a->path_lines), a->json);
    if (!error && text)
        write_text(a, w, o, &error);
    return error ? failed(error, CLI_EXIT_OUTPUT) : 0;
}

static bool all_answer(const struct reruns *r)
{
    for (size_t i = 0; i < r->count; i++)
        if (!r->list[i].done)
            return false;
    return true;
}

static int explain(const struct arguments *a)
{
    struct why *w = why_of(a->path, &a->select), *than = NULL;
    struct reruns reruns = {0};
    int status = w ? 0 : CLI_EXIT_INPUT;
    if (!status && a->than && !(than = why_of(a->than, &(struct trace_selection){0})))
        status = CLI_EXIT_INPUT;
    if (!status && a->rerun)
        status = run_again(a, w->t, &reruns);
    struct why_report_options o = {.top = a->top, .reruns = a->rerun ? &reruns : NULL, .than = than};
    if (!status)
        status = write_all(a, w, &o);
    if (!status && !all_answer(&reruns))
        status = CLI_EXIT_INPUT;
    reruns_free(&reruns);
    why_free(than);
    why_free(w);
    return status;
}

int cli_trace_why(int argc, char **argv)
{
    static const struct argp_child CHILDREN[] = {
        {&CLI_TRACE_SELECTION, 0, "What to look at:", 0}, {&CLI_JOBS, 0, NULL, 2}, {0}};
    static const struct argp ARGP = {OPTIONS, parse, "TRACE", DOC, CHILDREN, NULL, NULL};
    struct arguments a = {.output = "-", .top = USUAL_TOP, .set = xcalloc((size_t)argc + 1, sizeof *a.set)};
    cli_parse(&ARGP, "touchstone trace why", 0, argc, argv, &a);
    int status = explain(&a);
    free((bool *)(uintptr_t)a.select.nodes);
    free(a.set);
    return status;
}
