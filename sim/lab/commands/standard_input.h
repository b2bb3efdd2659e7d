/* standard_input.h - the command's standard input, for the many runs that it starts. */
#ifndef LAB_COMMANDS_STANDARD_INPUT_H
#define LAB_COMMANDS_STANDARD_INPUT_H
#include <stdbool.h>
#include <stddef.h>

/* Reads all of it into *input, malloc'd, of so many bytes; a terminal's is left alone. False with *error
 * malloc'd. */
bool standard_input_read(char **input, size_t *bytes, char **error);
#endif
