/* shared_names.h - the check of whether a program needs shared libraries of this computer. */
#ifndef DRIVER_SHARED_NAMES_H
#define DRIVER_SHARED_NAMES_H

/* Looks at a program that has just been linked. The linker finds a name in a shared library of this computer
 * as readily as in an archive, but a node loads no libraries: if there is such a name, names it and the
 * libraries, removes the program and exits with status 1. offered: libnode.so, which has the names that nodes
 * have. */
void shared_names_check(const char *program, const char *offered);

#endif
