/* options.c - see options.h. */
#include "cli/options.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli/describe.h"
#include "cli/nearest.h"
#include "cli/version.h"
#include "files/virtual_time.h"

enum { USAGE = CLI_KEY, SHOW_VERSION, DESCRIBE, MAX_JOBS = 1024 };

/* --- the options of every command --- */

static const struct argp_option HELP_OPTIONS[] = {
    {"help", 'h', NULL, 0, "Show this help", -1},
    {"usage", USAGE, NULL, 0, "Show the options in short", -1},
    {"version", SHOW_VERSION, NULL, 0, "Show version and commit", -1},
    {"describe", DESCRIBE, NULL, OPTION_HIDDEN, NULL, -1},
    {0}};

static error_t parse_help(int key, char *arg, struct argp_state *state)
{
    switch (key) {
    case ARGP_KEY_INIT:
        cli_check_options(state);
        return 0;
    case 'h':
        argp_state_help(state, state->out_stream, ARGP_HELP_STD_HELP);
        return 0;
    case USAGE:
        argp_state_help(state, state->out_stream, ARGP_HELP_USAGE | ARGP_HELP_EXIT_OK);
        return 0;
    case SHOW_VERSION:
        cli_version_print(state->out_stream);
        exit(0);
    case DESCRIBE:
        cli_describe(state->root_argp, state->out_stream);
        exit(0);
    case ARGP_KEY_ARG: /* the command's own parser did not take it */
        argp_error(state, "'%s' is one argument too many", arg);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

void cli_parse(const struct argp *command, const char *name, unsigned flags, int argc, char **argv,
               void *input)
{
    static const struct argp HELP = {HELP_OPTIONS, parse_help, NULL, NULL, NULL, NULL, NULL};
    const struct argp_child children[] = {{command, 0, NULL, 0}, {&HELP, 0, NULL, 0}, {0}};
    const struct argp all = {.children = children}; /* without a parser: the first child gets the input */
    char *own = argv[0];
    argv[0] = (char *)(uintptr_t)name; /* argp's messages begin with it */
    argp_parse(&all, argc, argv, flags | ARGP_NO_HELP, NULL, input);
    argv[0] = own;
}

error_t cli_store(int key, char *arg, struct argp_state *state)
{
    if (key < 0 || key >= CLI_KEY_END)
        return ARGP_ERR_UNKNOWN; /* one of argp's own */
    if (key >= CLI_KEY_FLAG)
        *(bool *)((char *)state->input + (key - CLI_KEY_FLAG)) = true;
    else if (key >= CLI_KEY_TEXT)
        *(const char **)((char *)state->input + (key - CLI_KEY_TEXT)) = arg;
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

error_t cli_store_only(const char **only, const char *arg)
{
    if (*only)
        return ARGP_ERR_UNKNOWN;
    *only = arg;
    return 0;
}

/* --- options of several commands --- */

static const struct argp_option MACHINE_OPTIONS[] = {
    {"machine", 'm', "MACHINE", 0, "Machine file: NAME for machines/NAME.cfg, or a path", 1}, {0}};

static error_t parse_machine(int key, char *arg, struct argp_state *state)
{
    if (key != 'm')
        return ARGP_ERR_UNKNOWN;
    *(const char **)state->input = arg;
    return 0;
}

const struct argp CLI_MACHINE = {MACHINE_OPTIONS, parse_machine, NULL, NULL, NULL, NULL, NULL};

static const struct argp_option JOBS_OPTIONS[] = {
    {"jobs", 'j', "JOBS", 0, "Number of runs at a time; default the number of processors", 1}, {0}};

static error_t parse_jobs(int key, char *arg, struct argp_state *state)
{
    if (key != 'j')
        return ARGP_ERR_UNKNOWN;
    *(unsigned *)state->input = cli_whole(state, "-j", "a number of jobs", MAX_JOBS, arg);
    return 0;
}

const struct argp CLI_JOBS = {JOBS_OPTIONS, parse_jobs, NULL, NULL, NULL, NULL, NULL};

/* --- values --- */

static bool is_positive(const char *text, double *value)
{
    char *end;
    *value = strtod(text, &end);
    return *text && !*end && *value > 0;
}

bool cli_is_whole(const char *text, uint32_t most, uint32_t *value)
{
    double x;
    if (!is_positive(text, &x) || x > most || x != (double)(uint32_t)x)
        return false;
    *value = (uint32_t)x;
    return true;
}

uint32_t cli_whole(struct argp_state *state, const char *option, const char *what, uint32_t most,
                   const char *text)
{
    uint32_t value = 0;
    if (cli_is_whole(text, most, &value))
        return value;
    if (most == UINT32_MAX)
        argp_error(state, "%s takes %s, 1 or more, not '%s'", option, what, text);
    else
        argp_error(state, "%s takes %s, 1 to %u, not '%s'", option, what, most, text);
    return value;
}

vtime cli_virtual_time(struct argp_state *state, const char *option, const char *text)
{
    vtime t = 0;
    if (!virtual_time_read(text, &t))
        argp_error(state, "%s takes a virtual time such as 1.5s, 12ms or 3us, not '%s'", option, text);
    return t;
}

vtime cli_later_time(struct argp_state *state, const char *option, const char *text)
{
    vtime t = cli_virtual_time(state, option, text);
    if (!t)
        argp_error(state, "%s takes a virtual time later than 0", option);
    return t;
}

double cli_seconds(struct argp_state *state, const char *option, const char *text)
{
    double value;
    if (!is_positive(text, &value))
        argp_error(state, "%s takes seconds, more than 0, not '%s'", option, text);
    return value;
}

static unsigned processors_here(void)
{
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    return processors > 0 ? (unsigned)processors : 1;
}

unsigned cli_jobs(unsigned asked)
{
    return asked ? asked : processors_here();
}

unsigned cli_workers(uint32_t asked)
{
    enum { USUAL = 8 };
    unsigned processors = processors_here();
    const char *told = getenv("TOUCHSTONE_WORKERS");
    uint32_t n;
    if (asked)
        return asked;
    if (told && cli_is_whole(told, CLI_MOST_WORKERS, &n))
        return n;
    return processors < USUAL ? processors : USUAL;
}
