/* options.h - the reading of commands' arguments: by glibc's argp, one struct argp a command, whose
 * table has the options, their arguments and their help. What the commands share stands here.
 *
 * A wrong argument ends the process with argp_err_exit_status, 64 unless a command says otherwise, after
 * a message that names the option and says what it takes. */
#ifndef CLI_OPTIONS_H
#define CLI_OPTIONS_H
#include <argp.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "kernel/vtime.h"

enum {
    CLI_EXIT_USAGE = 64,  /* a command's exit status: wrong arguments, as argp's */
    CLI_EXIT_INPUT = 65,  /* a command's exit status: its input cannot be used */
    CLI_EXIT_OUTPUT = 74, /* standard output or a result cannot be written */

    /* keys of options without a short form */
    CLI_KEY = 0x100,        /* from here on: the command's parser handles the option */
    CLI_KEY_TEXT = 0x10000, /* cli_store() does */
    CLI_KEY_FLAG = 0x20000,
    CLI_KEY_END = 0x30000
};

/* Keys of options whose value, or true, cli_store() stores in a member of the struct of that type at
 * state->input. */
#define CLI_TEXT(type, member) (CLI_KEY_TEXT + CLI_OFFSET(struct type, member, const char *))
#define CLI_FLAG(type, member) (CLI_KEY_FLAG + CLI_OFFSET(struct type, member, bool))
#define CLI_OFFSET(type, member, kind) _Generic(((type *)0)->member, kind : (int)offsetof(type, member))
error_t cli_store(int key, char *arg, struct argp_state *state);
/* Stores a command's one argument, for ARGP_KEY_ARG; a second one is an error. */
error_t cli_store_only(const char **only, const char *arg);

/* Parses a command's arguments; its parser finds input as state->input. name: as in "touchstone run".
 * flags: argp's. Adds -h, --help, --usage and --version. Arguments that the command's parser does not
 * know are an error. */
void cli_parse(const struct argp *command, const char *name, unsigned flags, int argc, char **argv,
               void *input);

/* Children (struct argp_child) of commands that have these options. */
extern const struct argp CLI_MACHINE; /* -m MACHINE; input: const char ** */
extern const struct argp CLI_JOBS;    /* -j JOBS; input: unsigned * */

/* Is text a whole number from 1 to most? */
bool cli_is_whole(const char *text, uint32_t most, uint32_t *value);
/* Values of options: a whole number from 1 to most; seconds, more than 0. Any other text is reported as
 * an error of that option. what: as in "a number of nodes". */
uint32_t cli_whole(struct argp_state *state, const char *option, const char *what, uint32_t most,
                   const char *text);
/* A virtual time such as 1.5s, 12ms, 3us, 40ns or 1234ps; a number alone is in seconds. */
vtime cli_virtual_time(struct argp_state *state, const char *option, const char *text);
vtime cli_later_time(struct argp_state *state, const char *option, const char *text); /* than 0 */
double cli_seconds(struct argp_state *state, const char *option, const char *text);

/* How many runs at a time: as many as asked for; 0: as many as this computer has processors. */
unsigned cli_jobs(unsigned asked);
/* How many threads a run has: as many as asked for; 0: $TOUCHSTONE_WORKERS, or as many as there are
 * processors, at most 8. */
enum { CLI_MOST_WORKERS = 256 };
unsigned cli_workers(uint32_t asked);
#endif
