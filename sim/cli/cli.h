/* cli.h - touchstone's subcommands: each takes its own arguments (argv[0] its name) and returns the exit
 * status. */
#ifndef CLI_CLI_H
#define CLI_CLI_H
#include <limits.h>
#include <stdbool.h>

int cli_check(int argc, char **argv);
int cli_fit(int argc, char **argv);
int cli_plot(int argc, char **argv);
int cli_run(int argc, char **argv);
int cli_study(int argc, char **argv);
int cli_tables(int argc, char **argv);
int cli_srm(int argc, char **argv);
int cli_cube(int argc, char **argv);          /* getcube, load and their kin, by argv[0] */
extern const char *const CLI_CUBE_COMMANDS[]; /* ended by NULL */
bool cli_is_cube_command(const char *name);

/* Is it an engine (lp/engine.h) that this binary does not have? Calls the one that does, with main's argv. Returns an exit status
 * if that cannot be. */
bool cli_is_other_engine(const char *engine);
int cli_change_engine(const char *engine, char **argv);
enum { CLI_EXIT_INPUT = 65 };

/* For errors in arguments: "touchstone run: what is wrong", then where to find help. Returns 2... see each
 * command. */
int cli_usage(const char *command, const char *fmt, ...) __attribute__((format(printf, 2, 3)));

/* For subcommands that run many programs, so many at a time. */
enum { CLI_MAX_JOBS = 1024, CLI_MAX_PROGRAMS = PATH_MAX + 32 };
unsigned cli_processors(void);
bool cli_jobs(const char *text, unsigned *jobs); /* false unless it is from 1 to CLI_MAX_JOBS */

/* This binary, and where the node programs built with it are: beside it in a build, in lib/touchstone when installed. */
bool cli_find_programs(char runner[PATH_MAX], char programs[CLI_MAX_PROGRAMS]);
#endif
