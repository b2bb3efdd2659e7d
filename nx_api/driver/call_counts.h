/* call_counts.h - the check of whether calls of NX and MPI have as many arguments as theirs. */
#ifndef DRIVER_CALL_COUNTS_H
#define DRIVER_CALL_COUNTS_H

/* Looks at a program that has just been linked. A call in C, without a prototype, that has too few arguments
 * is a warning: programs of the time left out a pid that no node looks at. So is a call of MPI in Fortran
 * with too many, which does no harm. Others in Fortran are errors: removes the program and exits with status
 * 1. But programs by which Autoconf and CMake ask whether there is a call may give it no arguments. */
void call_counts_check(const char *program);

#endif
