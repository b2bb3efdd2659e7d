/* commands.h - the commands that simulate, and allocate nodes. Each takes its own arguments, argv[0] being
 * its name, and returns the exit status; wrong arguments, --help, --usage and --version end the process
 * (options.h). The other commands are those of lab/commands/lab_commands.h. */
#ifndef CLI_COMMANDS_H
#define CLI_COMMANDS_H
#include <argp.h>
#include "cli/program_options.h"

int cli_run(int argc, char **argv);
int cli_srm(int argc, char **argv);

/* What a command line of touchstone run asks for, without where its results go. The texts are argv's. */
struct cli_run_parts {
    struct cli_program what; /* the caller frees it: cli_program_free() */
    const char *cfs, *json;  /* NULL: not given */
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
#endif
