/* fortran_calls.h - the check of whether calls of NX and MPI in Fortran have as many arguments as theirs. */
#ifndef DRIVER_FORTRAN_CALLS_H
#define DRIVER_FORTRAN_CALLS_H

/* Looks at a program that has just been linked. Removes the program and exits with status 1, with a message
 * for each call that has too few or too many arguments. */
void fortran_calls_check(const char *program);

#endif
