/* trace_command.c - touchstone trace: what there is to do with a trace, and its head. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lab/commands/lab_commands.h"
#include "cli/nearest.h"
#include "cli/say.h"
#include "cli/trace_options.h"
#include "files/json_set.h"
#include "files/virtual_time.h"
#include "kernel/xalloc.h"
#include "observe/json_file.h"

static const struct trace_command {
    const char *name;
    int (*run)(int argc, char **argv);
    const char *what;
} COMMANDS[] = {
    {"info", cli_trace_info, "Show what a trace has"},
    {"show", cli_trace_show, "Draw pictures: utilisation, Gantt, space-time, matrix, channels ..."},
    {"export", cli_trace_export, "Write a trace for other tools: Perfetto, Paje, Vampir, ParaGraph, tables"},
    {"why", cli_trace_why, "Say why the run took its time: critical path, causes of waits"}};
enum { COMMAND_COUNT = sizeof COMMANDS / sizeof *COMMANDS };

/* --- touchstone trace info --- */

struct info_arguments {
    const char *path, *json;
    struct trace_selection select;
};

static const struct argp_option INFO_OPTIONS[] = {
    {"json", CLI_TEXT(info_arguments, json), "FILE", 0,
     "Write JSON, too; '-' is standard output, which has no text then", 0},
    {0}};

static error_t parse_info(int key, char *arg, struct argp_state *state)
{
    struct info_arguments *a = state->input;
    if (key == ARGP_KEY_INIT)
        state->child_inputs[0] = &a->select;
    else if (key == ARGP_KEY_ARG)
        return cli_store_only(&a->path, arg);
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "which trace? (written by touchstone run --trace FILE)");
    else
        return cli_store(key, arg, state);
    return 0;
}

static const char INFO_DOC[] =
    "Shows what a trace of touchstone run --trace has: the command of the run, its machine, how many calls, "
    "handlers and messages there are, and how the nodes' time is divided. The text goes to standard output.\v"
    "Exit status:\n"
    "  0   done\n"
    "  64  wrong arguments\n"
    "  65  the trace cannot be used, or FILE not written\n\n"
    "Example:\n"
    "  touchstone trace info --nodes 0-7 --from 1ms --to 2ms ring.trace";

/* Adds up how long the nodes were in each state. */
static void add_states(const struct trace *t, vtime states[TRACE_STATES])
{
    for (int32_t i = 0; i < t->node_count; i++) {
        struct trace_pieces p = {0};
        trace_pieces(t, i, &p);
        for (size_t k = 0; k < p.count; k++)
            states[p.list[k].state] += p.list[k].end - p.list[k].begin;
        free(p.list);
    }
}

static void print_info(const struct trace *t, const vtime states[TRACE_STATES], FILE *f)
{
    vtime all = 0;
    fprintf(f, "%s\n", t->command);
    fprintf(f, "machine          %s, %" PRId32 " nodes%s\n", t->machine, trace_nodes_ran(t),
            t->topo.host ? " and the host" : "");
    fprintf(f, "time             %s to %s of %s%s\n", virtual_time_moment(t->from).text,
            virtual_time_moment(t->to).text, virtual_time_moment(t->end).text,
            t->complete ? "" : " (the trace is cut off: the run was killed)");
    fprintf(f, "calls            %" PRId32 ", with %" PRId32 " waits\n", t->call_count, t->wait_count);
    fprintf(f, "handlers         %" PRId32 "\n", t->handler_count);
    fprintf(f, "system intervals %" PRId32 "\n", t->system_count);
    fprintf(f, "messages         %" PRId32 ", with %" PRId32 " waits for channels\n", t->message_count,
            t->block_count);
    for (int s = 0; s < TRACE_STATES; s++)
        all += states[s];
    for (int s = 0; s < TRACE_STATES && all; s++)
        fprintf(f, "%-16s %5.1f %% of the nodes' time\n", trace_state_name((enum trace_state)s),
                100 * (double)states[s] / (double)all);
    fprintf(f, "digest           %016" PRIx64 "\n", t->digest);
}

static json_t *info_json(const struct trace *t, const vtime states[TRACE_STATES])
{
    static const char *const KEYS[TRACE_ENDED] = {"computing", "calls", "waiting", "system"};
    json_t *times = xchecked(json_object());
    for (int s = 0; s < TRACE_ENDED; s++)
        json_set(times, KEYS[s], json_integer((json_int_t)states[s]));
    char digest[17];
    snprintf(digest, sizeof digest, "%016" PRIx64, t->digest);
    return xchecked(
        json_pack("{s:s, s:o, s:s, s:i, s:I, s:I, s:I, s:b, s:i, s:i, s:i, s:i, s:i, s:i, s:o, s:s}",
                  "format", "touchstone trace-info 1", "command", json_text(t->command), "machine",
                  t->machine, "nodes", (int)trace_nodes_ran(t), "from_ps", (json_int_t)t->from, "to_ps",
                  (json_int_t)t->to, "end_ps", (json_int_t)t->end, "complete", (int)t->complete, "calls",
                  (int)t->call_count, "waits", (int)t->wait_count, "handlers", (int)t->handler_count,
                  "system_intervals", (int)t->system_count, "messages", (int)t->message_count,
                  "waits_for_channels", (int)t->block_count, "states_ps", times, "digest", digest));
}

static int write_info(const struct trace *t, const char *json)
{
    vtime states[TRACE_STATES] = {0};
    add_states(t, states);
    if (!json || strcmp(json, "-") != 0)
        print_info(t, states, stdout);
    char *error = json ? json_file_write(info_json(t, states), json) : NULL;
    return error ? cli_failed("trace info", error, CLI_EXIT_INPUT) : 0;
}

int cli_trace_info(int argc, char **argv)
{
    static const struct argp_child CHILDREN[] = {{&CLI_TRACE_SELECTION, 0, NULL, 0}, {0}};
    static const struct argp ARGP = {INFO_OPTIONS, parse_info, "TRACE", INFO_DOC, CHILDREN, NULL, NULL};
    struct info_arguments a = {0};
    char *error = NULL;
    cli_parse(&ARGP, "touchstone trace info", 0, argc, argv, &a);
    struct trace *t = trace_load(a.path, &a.select, &error);
    free((bool *)(uintptr_t)a.select.nodes);
    if (!t)
        return cli_failed("trace info", error, CLI_EXIT_INPUT);
    int status = write_info(t, a.json);
    trace_free(t);
    return status;
}

/* --- touchstone trace --- */

/* What is asked for: a command, whose name is argv[at]. */
struct request {
    const struct trace_command *command;
    int at;
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct request *r = state->input;
    if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "what to do with the trace?");
    if (key != ARGP_KEY_ARG || r->command)
        return ARGP_ERR_UNKNOWN;
    for (const struct trace_command *c = COMMANDS; c < COMMANDS + COMMAND_COUNT; c++)
        if (!strcmp(c->name, arg))
            r->command = c;
    if (!r->command)
        cli_no_such_command(state, "trace ", arg);
    r->at = state->next - 1;
    state->next = state->argc; /* the rest is the command's */
    return 0;
}

int cli_trace(int argc, char **argv)
{
    struct argp_option lines[COMMAND_COUNT + 2] = {{.doc = "Commands:", .group = 1}};
    for (int i = 0; i < COMMAND_COUNT; i++)
        lines[i + 1] =
            (struct argp_option){.name = COMMANDS[i].name, .doc = COMMANDS[i].what, .flags = OPTION_DOC};
    const struct argp argp = {lines,
                              parse,
                              "COMMAND [ARGS...] TRACE",
                              "Looks into a run: what each node and message did, and when, as touchstone run "
                              "--trace FILE has written it.\v"
                              "touchstone trace COMMAND --help describes a command.\n\n"
                              "Exit status: the command's own; 64 if there is no such command.\n\n"
                              "Example:\n"
                              "  touchstone run -m ipsc860 -n 16 --trace ring.trace ring\n"
                              "  touchstone trace info ring.trace",
                              NULL,
                              NULL,
                              NULL};
    struct request r = {0};
    cli_parse(&argp, "touchstone trace", ARGP_IN_ORDER, argc, argv, &r);
    return r.command->run(argc - r.at, argv + r.at);
}
