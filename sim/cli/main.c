/* main.c - touchstone: finds the subcommand. */
#include <signal.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cli/cli.h"

static const char HELP[] =
    "touchstone runs programs written for Intel's NX message-passing library on simulated\n"
    "iPSC/860, Touchstone Delta and Paragon nodes, in exact virtual time.\n"
    "\n"
    "  touchstone run     run a program built by nxcc on a machine\n"
    "  touchstone study   run a program over several axes: nodes, machine, arguments\n"
    "  touchstone plot    draw the pictures of a study again, from its results\n"
    "  touchstone check   compare a study with a baseline: what got slower, and where\n"
    "  touchstone fit     fit numbers of a machine to measurements\n"
    "  touchstone tables  reproduce Tables 1-5 of Bajaj & Lin, beside the paper's\n"
    "  touchstone srm     share out a machine's nodes among users, as its host did\n"
    "  touchstone getcube, cubeinfo, attachcube, load, waitcube, killcube, relcube\n"
    "                     ask it for a cube of nodes, run programs there, give it back\n"
    "\n"
    "touchstone COMMAND --help tells more. Programs are built with nxcc: nxcc -O2 -o prog prog.c\n";

int cli_usage(const char *command, const char *fmt, ...)
{
    va_list ap;
    va_start(ap, fmt);
    fprintf(stderr, "touchstone %s: ", command);
    vfprintf(stderr, fmt, ap);
    fprintf(stderr, "\ntouchstone %s --help tells how it is used\n", command);
    va_end(ap);
    return 64;
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        int (*run)(int, char **);
    } COMMANDS[] = {{"run", cli_run}, {"study", cli_study},   {"plot", cli_plot}, {"check", cli_check},
                    {"fit", cli_fit}, {"tables", cli_tables}, {"srm", cli_srm}};
    signal(SIGXFSZ, SIG_IGN); /* a file that may not grow is an error of its writing */
    const char *slash = argc > 0 ? strrchr(argv[0], '/') : NULL, *called = slash      ? slash + 1
                                                                           : argc > 0 ? argv[0]
                                                                                      : "";
    const char *engine = getenv("TOUCHSTONE_ENGINE");
    if (engine && cli_is_other_engine(engine))
        return cli_change_engine(engine, argv);
    if (cli_is_cube_command(called)) { /* through a link of that name */
        argv[0] = (char *)(uintptr_t)called;
        return cli_cube(argc, argv);
    }
    if (argc < 2 || !strcmp(argv[1], "--help") || !strcmp(argv[1], "-h") || !strcmp(argv[1], "help")) {
        fputs(HELP, argc < 2 ? stderr : stdout);
        return argc < 2 ? 64 : 0;
    }
    for (size_t i = 0; i < sizeof COMMANDS / sizeof COMMANDS[0]; i++)
        if (!strcmp(argv[1], COMMANDS[i].name))
            return COMMANDS[i].run(argc - 1, argv + 1);
    if (cli_is_cube_command(argv[1]))
        return cli_cube(argc - 1, argv + 1);
    fprintf(stderr, "touchstone: there is no command '%s'\n\n%s", argv[1], HELP);
    return 64;
}
