/* cli.h - touchstone's subcommands: each takes its own arguments (argv[0] its name) and returns the exit
 * status. */
#ifndef CLI_CLI_H
#define CLI_CLI_H

int cli_run(int argc, char **argv);
int cli_tables(int argc, char **argv);

/* For errors in arguments: "touchstone run: what is wrong", then where to find help. Returns 2... see each
 * command. */
int cli_usage(const char *command, const char *fmt, ...) __attribute__((format(printf, 2, 3)));
#endif
