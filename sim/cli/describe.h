/* describe.h - a command's options as lines for programs: the completions of shells are made from them. */
#ifndef CLI_DESCRIBE_H
#define CLI_DESCRIBE_H
#include <argp.h>
#include <stdio.h>

/* Writes lines of fields between tabs, an empty field being "-", of the command and its children:
 *     arguments  PROGRAM [ARGS...]                     what stands behind the options
 *     option     -n  --nodes  NODES  Number of nodes   short name, long name, value, what it does
 *     word       run  Run a program ...                a command, or another word that may be an argument
 * A value of alternatives, as "json|csv", is one of these. */
void cli_describe(const struct argp *command, FILE *f);
#endif
