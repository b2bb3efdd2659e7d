/* nearest.h - what a user may have meant who gave a command, or an option, that there is not. */
#ifndef CLI_NEAREST_H
#define CLI_NEAREST_H
#include <argp.h>
#include <stddef.h>

/* Ends the process, as argp_error() does: there is no such command. prefix: "" or "trace ". Names the command
 * that may have been meant: of the words that the help shows (OPTION_DOC). */
void cli_no_such_command(struct argp_state *state, const char *prefix, const char *name);

/* The first long option in the arguments, as getopt reads them, that the command has not: ends the process,
 * as argp_error() does, and names the option that is like it, else those whose help has its word. Returns if
 * there is none. Call at ARGP_KEY_INIT, before getopt refuses it without a hint. */
void cli_check_options(struct argp_state *state);
#endif
