/* logicals.h - Fortran programs that compare logicals with .eq. and .ne., as compilers of the time let them.
 * GNU Fortran refuses that with any option, so they are compiled from copies in which these comparisons read
 * (a .eqv. b) and (a .neqv. b); messages and debugging information name the lines of the original. */
#ifndef DRIVER_LOGICALS_H
#define DRIVER_LOGICALS_H
#include "nx_api/driver/arguments.h"

/* Runs the command for gcc (command.h), which compiles Fortran files of the user's, and once more from
 * copies if it fails for such comparisons alone or among others. Returns gcc's exit status. */
int logicals_run(const char **gcc, const struct arguments *user);

#endif
