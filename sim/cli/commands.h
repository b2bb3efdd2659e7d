/* commands.h - touchstone's commands. Each takes its own arguments, argv[0] being its name, and returns
 * the exit status; wrong arguments, --help, --usage and --version end the process (options.h). */
#ifndef CLI_COMMANDS_H
#define CLI_COMMANDS_H
#include <argp.h>
#include <stdbool.h>
#include "cli/program_options.h"

int cli_check(int argc, char **argv);
int cli_explore(int argc, char **argv);
int cli_deadlock(int argc, char **argv);
int cli_fit(int argc, char **argv);
int cli_page(int argc, char **argv);
int cli_plot(int argc, char **argv);
int cli_profile(int argc, char **argv);
int cli_render(int argc, char **argv);
int cli_run(int argc, char **argv);
int cli_serve(int argc, char **argv);
int cli_study(int argc, char **argv);
int cli_tables(int argc, char **argv);
int cli_srm(int argc, char **argv);
int cli_trace(int argc, char **argv);

/* touchstone trace's commands; argv[0] is the command's name. */
int cli_trace_info(int argc, char **argv);
int cli_trace_show(int argc, char **argv);
int cli_trace_export(int argc, char **argv);
int cli_trace_why(int argc, char **argv);

/* What a command line of touchstone run asks for, without where its results go. The texts are argv's. */
struct cli_run_parts {
    struct cli_program what; /* the caller frees its list of settings */
    const char *cfs;         /* NULL: not given */
    const char **host_files; /* of --host-files, ended by NULL; NULL: none. The caller frees the list */
};
/* argv[0] is "run". A wrong argument ends the process. */
void cli_run_read(int argc, char **argv, struct cli_run_parts *parts);

/* The commands of the host's shell, such as getcube; cli_cube() is all of them, by argv[0]. */
struct cli_cube_command {
    const char *name, *what; /* what: one line of help */
    const struct argp_option *options;
    argp_parser_t parse;
    const char *arguments; /* as in struct argp */
};
extern const struct cli_cube_command CLI_CUBE_COMMANDS[];          /* the last one has no name */
const struct cli_cube_command *cli_cube_command(const char *name); /* NULL: there is none of that name */
int cli_cube(int argc, char **argv);

/* Is engine (node/engine.h) one that this binary does not have? */
bool cli_is_other_engine(const char *engine);
/* Executes the binary that has the engine, with main's argv. Returns an exit status if that binary cannot
 * be executed. */
int cli_change_engine(const char *engine, char **argv);
#endif
