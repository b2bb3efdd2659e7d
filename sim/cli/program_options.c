/* program_options.c - see program_options.h. */
#include "cli/program_options.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "config/config.h"
#include "files/program_file.h"
#include "kernel/xalloc.h"

enum { SET = CLI_KEY + 0x2000, MAX_VIRTUAL, MAX_WALL, MAX_UNRECEIVED };
enum { MOST_UNRECEIVED_MB = 1 << 20 };

const char CLI_PROGRAM_ARGUMENTS[] = "PROGRAM [ARGS...]\n--host=HOST [PROGRAM [ARGS...]]";

static const struct argp_option OPTIONS[] = {
    {NULL, 0, NULL, 0, "Machine:", 1},
    {"nodes", 'n', "NODES", 0,
     "Number of nodes; default 1. Other programs get the nodes after them: -n 1 PROGRAM ARGS : -n 4 OTHER "
     "ARGS",
     0},
    {"set", SET, "KEY=VALUE", 0,
     "Value for a key of the machine file, such as system.interrupt_us=150; may be repeated", 0},
    {"host", CLI_TEXT(cli_program, host), "HOST", 0, "Run HOST, built by nxcc -host, on the machine's host",
     0},
    {NULL, 0, NULL, 0, "Limits of a run:", 3},
    {"max-virtual-time", MAX_VIRTUAL, "S", 0, "Stop when a node passes S seconds of virtual time", 0},
    {"max-wall-time", MAX_WALL, "S", 0, "Stop after S seconds of real time", 0},
    {"max-unreceived", MAX_UNRECEIVED, "MB", 0,
     "Stop when messages that no receive takes fill so much of a node; default 4 times its memory, at most "
     "4096",
     0},
    {0}};

void cli_add_setting(struct argp_state *state, const char **set, size_t *count, const char *setting)
{
    if (!strchr(setting, '=') || *setting == '=')
        argp_error(state, "--set takes KEY=VALUE, such as system.interrupt_us=150, not '%s'", setting);
    set[(*count)++] = setting;
}

static void begin(struct argp_state *state, struct cli_program *p)
{
    p->set = xcalloc((size_t)state->argc + 1, sizeof *p->set);
    state->child_inputs[0] = &p->machine;
}

/* What follows the program's name is the program's, up to other programs. */
static void take_programs(struct argp_state *state, struct cli_program *p)
{
    p->program = state->argv + state->next;
    p->program_count = state->argc - state->next;
    for (int i = 0, count; i < p->program_count; i += count + 3) {
        char **words = p->program + i;
        count = named_program_words(words, p->program_count - i);
        p->programs = xgrown(p->programs, p->programs_count, sizeof *p->programs);
        p->programs[p->programs_count++] = (struct named_program){
            i ? cli_whole(state, "-n", "a number of nodes", UINT32_MAX, words[-1]) : 0, count, words};
    }
}

/* No program is there: the last argument is an option's value, as prog of `--races prog`. */
static void ask_for_program(struct argp_state *state)
{
    const char *last = state->argv[state->argc - 1];
    if (state->argc > 2 && access(last, X_OK) == 0)
        argp_error(state, "which program? (built by nxcc; %s was taken as the value of %s)", last,
                   state->argv[state->argc - 2]);
    else
        argp_error(state, "which program? (built by nxcc)");
}

static uint64_t all_nodes(const struct cli_program *p)
{
    uint64_t all = p->nodes;
    for (size_t i = 1; i < p->programs_count; i++)
        all += p->programs[i].nodes;
    return all;
}

static void check(struct argp_state *state, struct cli_program *p)
{
    if (!p->host && !p->program_count)
        ask_for_program(state);
    if (!p->host && !p->nodes)
        p->nodes = 1;
    if (p->programs_count)
        p->programs[0].nodes = p->nodes;
    if (p->host && p->programs_count > 1)
        argp_error(state, "with --host, HOST loads the nodes: no ': -n NODES PROGRAM'");
    if (all_nodes(p) > UINT32_MAX)
        argp_error(state, "the programs have more nodes than a machine can have");
    if (!p->machine)
        p->machine = p->host ? CFG_USUAL_HOST_MACHINE : CFG_USUAL_MACHINE;
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct cli_program *p = state->input;
    if (key == ARGP_KEY_INIT)
        begin(state, p);
    else if (key == 'n')
        p->nodes = cli_whole(state, "-n", "a number of nodes", UINT32_MAX, arg);
    else if (key == SET)
        cli_add_setting(state, p->set, &p->set_count, arg);
    else if (key == MAX_VIRTUAL)
        p->max_virtual_s = cli_seconds(state, "--max-virtual-time", arg);
    else if (key == MAX_WALL)
        p->max_wall_s = cli_seconds(state, "--max-wall-time", arg);
    else if (key == MAX_UNRECEIVED)
        p->max_unreceived_mb =
            cli_whole(state, "--max-unreceived", "a number of MB", MOST_UNRECEIVED_MB, arg);
    else if (key == ARGP_KEY_ARGS)
        take_programs(state, p);
    else if (key == ARGP_KEY_END)
        check(state, p);
    else
        return cli_store(key, arg, state);
    return 0;
}

static bool find(struct cli_program *p, char **name, const char *brought, bool verbose, char **error)
{
    char *path = program_file_find(*name, NULL, brought, error);
    if (!path || !strcmp(path, *name)) {
        free(path);
        return !*error;
    }
    if (verbose)
        fprintf(stderr, "%s is not here: it is %s\n", *name, path);
    p->found = xreallocarray(p->found, p->found_count + 1, sizeof *p->found);
    *name = p->found[p->found_count++] = path;
    return true;
}

uint32_t cli_program_nodes(const struct cli_program *p)
{
    return (uint32_t)all_nodes(p);
}

bool cli_program_find(struct cli_program *p, const char *brought, bool verbose, char **error)
{
    *error = NULL;
    for (size_t i = 0; i < p->programs_count; i++)
        if (!find(p, &p->programs[i].argv[0], brought, verbose, error))
            return false;
    char *host = (char *)(uintptr_t)p->host;
    if (host && !find(p, &host, brought, verbose, error))
        return false;
    p->host = host;
    return true;
}

void cli_program_free(struct cli_program *p)
{
    free(p->set);
    free(p->programs);
    for (size_t i = 0; i < p->found_count; i++)
        free(p->found[i]);
    free(p->found);
}

static const struct argp_child CHILDREN[] = {{&CLI_MACHINE, 0, NULL, 0}, {0}};
const struct argp CLI_PROGRAM = {OPTIONS, parse, NULL, NULL, CHILDREN, NULL, NULL};
