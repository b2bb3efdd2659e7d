/* say.h - what a command says of itself on standard error: "touchstone run: ...". */
#ifndef CLI_SAY_H
#define CLI_SAY_H

/* An error, of any number of lines, and what need not be one. command: "run", "trace show"; the text comes
 * without the line's end. On a terminal, the command is red, or yellow, and in a report of a deadlock the
 * first line and the cycle stand out. */
void cli_say_error(const char *command, const char *format, ...) __attribute__((format(printf, 2, 3)));
void cli_say_warning(const char *command, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* What a command does that may take a while, on a terminal only: the line is erased by what comes next, or by
 * cli_say_done(). */
void cli_say_doing(const char *what, const char *object);
void cli_say_done(void);
/* Says the error, frees it, and returns the status. */
int cli_failed(const char *command, char *error, int status);
/* From now on, a process of the command that ends well (also behind --help and --version, which argp ends)
 * fails with CLI_EXIT_OUTPUT and says so if what it has printed found no room. */
void cli_watch_output(const char *command);
#endif
