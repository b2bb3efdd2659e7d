/* debugger_file.h - a program's file as a debugger is to see it.
 *
 * A program is loaded once for each node, so that each of its global variables is there many times. Debuggers
 * take global variables of one name in several libraries for one variable, the first: that is what dynamic
 * loaders do. They make an exception, which is what each node needs, for
 *
 *     - names that a library looks up in itself first (DT_SYMBOLIC),
 *     - variables that are local to their library (STB_LOCAL), which nobody can have copied.
 *
 * GNU ld makes neither for executables, so debuggers get a copy of the file in which both are so. */
#ifndef GUEST_DEBUGGER_FILE_H
#define GUEST_DEBUGGER_FILE_H
#include "guest/elffile.h"

/* Writes the copy to a new file. False: that is not possible, errno says why. */
bool debugger_file_write(const struct elf_file *f, const char *path);
#endif
