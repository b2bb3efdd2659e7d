/* command_line.h - the command's arguments in the form in which arguments.c takes them: what a file has in
 * the place of @FILE, and -l m as -lm. */
#ifndef DRIVER_COMMAND_LINE_H
#define DRIVER_COMMAND_LINE_H

/* The arguments, which NULL ends; *argc becomes their number. */
char **command_line_read(int *argc, char **argv);

#endif
