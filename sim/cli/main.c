/* main.c - touchstone: finds the command. */
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli/commands.h"
#include "cli/installation.h"
#include "cli/nearest.h"
#include "cli/options.h"
#include "cli/other_binary.h"
#include "cli/say.h"
#include "config/config.h"

static const struct command {
    const char *name;
    int (*run)(int argc, char **argv); /* NULL: touchstone-lab does */
    const char *what;
} COMMANDS[] = {{"run", cli_run, "Run a program built by nxcc on a machine"},
                {"study", NULL, "Run a program for all values of several axes"},
                {"explore", NULL, "Run a program under other timings, and compare"},
                {"plot", NULL, "Draw pictures of a study's results"},
                {"render", NULL, "Draw surfaces, or write them in other formats"},
                {"page", NULL, "Show results in a browser: one HTML file"},
                {"serve", NULL, "Show results in a browser, live; run more points"},
                {"deadlock", NULL, "Show why programs wait for ever: text, picture, page"},
                {"check", NULL, "Compare studies with a baseline"},
                {"fit", NULL, "Fit numbers of a machine to measurements"},
                {"tables", NULL, "Reproduce Tables 1-5 of Bajaj & Lin"},
                {"trace", NULL, "Look into a run: timelines, pictures, what it waited for"},
                {"profile", NULL, "Show where the time of a run went: flame graphs, lines of source"},
                {"machines", NULL, "Show the machines, their numbers with sources, and differences"},
                {"srm", cli_srm, "Share out a machine's nodes among users"}};
enum { COMMAND_COUNT = sizeof COMMANDS / sizeof *COMMANDS, MOST_LINES = COMMAND_COUNT + 17 };

enum { MACHINES = CLI_KEY };

/* Lists the machines for the completions of shells; does not return. */
static void list_machines(void)
{
    struct cli_installation places;
    if (!cli_find_installation(&places, "--machines"))
        exit(CLI_EXIT_INPUT);
    if (cfg_list_machines(places.machines, "\n", stdout) > 0)
        putchar('\n');
    exit(0);
}

/* What main is asked to do: a command, whose name is argv[at]. */
struct request {
    int (*run)(int argc, char **argv); /* NULL: touchstone-lab is to */
    int at;                            /* 0: there is no command */
};

static bool find(const char *name, struct request *r)
{
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        if (!strcmp(name, COMMANDS[i].name)) {
            r->run = COMMANDS[i].run;
            return true;
        }
    r->run = cli_cube;
    return cli_cube_command(name);
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct request *r = state->input;
    if (key == MACHINES)
        list_machines();
    if (key == ARGP_KEY_NO_ARGS)
        argp_state_help(state, state->err_stream,
                        (ARGP_HELP_STD_HELP & ~ARGP_HELP_EXIT_OK) | ARGP_HELP_EXIT_ERR);
    if (key != ARGP_KEY_ARG || r->at)
        return ARGP_ERR_UNKNOWN;
    if (!strcmp(arg, "help"))
        argp_state_help(state, state->out_stream, ARGP_HELP_STD_HELP);
    if (!find(arg, r))
        cli_no_such_command(state, "", arg);
    r->at = state->next - 1;
    state->next = state->argc; /* the rest is the command's */
    return 0;
}

/* The commands as lines of help. */
static void list_commands(struct argp_option lines[MOST_LINES])
{
    struct argp_option *line = lines;
    *line++ = (struct argp_option){.doc = "Commands:", .group = 1};
    for (const struct command *c = COMMANDS; c < COMMANDS + COMMAND_COUNT; c++)
        *line++ = (struct argp_option){.name = c->name, .doc = c->what, .flags = OPTION_DOC};
    *line++ = (struct argp_option){.doc = "To use a machine that touchstone srm serves:", .group = 2};
    for (const struct cli_cube_command *c = CLI_CUBE_COMMANDS; c->name; c++)
        *line++ = (struct argp_option){.name = c->name, .doc = c->what, .flags = OPTION_DOC};
    *line++ = (struct argp_option){.name = "machines", .key = MACHINES, .flags = OPTION_HIDDEN};
}

/* "help run" is "run --help", and "help trace show" "trace show --help". What follows may be a program's. */
static void help_behind_command(int argc, char **argv)
{
    if (argc < 3 || strcmp(argv[1], "help") != 0)
        return;
    int words = argc > 3 && !strcmp(argv[2], "trace") ? 2 : 1;
    for (int i = 1; i <= words; i++)
        argv[i] = argv[i + 1];
    argv[words + 1] = "--help";
}

/* Takes the places of standard files that are closed, so that no result lies there, into which messages would
 * be written. Whoever reads or writes there gets an error as before. */
static void fill_closed(void)
{
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++)
        if (fcntl(fd, F_GETFD) < 0)
            open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int main(int argc, char **argv)
{
    fill_closed();
    cli_watch_output(argc > 1 ? argv[1] : "");
    signal(SIGXFSZ, SIG_IGN); /* then writing a file that may not grow fails, and is reported as an error */
    const char *engine = getenv("TOUCHSTONE_ENGINE"), *slash = argc > 0 ? strrchr(argv[0], '/') : NULL;
    if (engine && *engine && !cli_is_engine(engine)) {
        fprintf(stderr, "touchstone: TOUCHSTONE_ENGINE is 'fast' or 'reference', not '%s'\n", engine);
        return CLI_EXIT_USAGE;
    }
    if (engine && cli_is_other_engine(engine))
        return cli_change_engine(engine, argv);
    const char *called = slash ? slash + 1 : argc > 0 ? argv[0] : "";
    if (cli_cube_command(called)) { /* by a link of that name */
        argv[0] = (char *)(uintptr_t)called;
        return cli_cube(argc, argv);
    }
    struct argp_option lines[MOST_LINES] = {0};
    const struct argp argp = {
        lines,
        parse,
        "COMMAND [ARGS...]",
        "Runs parallel programs, written for Intel's NX or for MPI, on simulated nodes of an iPSC/860, a "
        "Touchstone Delta, a Paragon or a cluster, in exact virtual time. Programs are built with nxcc: "
        "nxcc -O2 -o prog prog.c\v"
        "touchstone COMMAND --help describes a command, and so does touchstone help COMMAND.\n\n"
        "Machine files are in machines/ of the installation, or of $TOUCHSTONE_HOME. On a terminal, messages "
        "are coloured, unless $NO_COLOR is set or $TERM is dumb; $CLICOLOR_FORCE has them coloured "
        "everywhere.\n\n"
        "Exit status: a command's own; 64 if there is no such command.\n\n"
        "Example:\n"
        "  nxcc -O2 -o ring ring.c && touchstone run -m ipsc860 -n 16 ring",
        NULL,
        NULL,
        NULL};
    struct request r = {0};
    help_behind_command(argc, argv);
    list_commands(lines);
    cli_parse(&argp, "touchstone", ARGP_IN_ORDER, argc, argv, &r);
    return r.run ? r.run(argc - r.at, argv + r.at) : cli_hand_to_lab(argv + r.at - 1);
}
