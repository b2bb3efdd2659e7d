/* dialect.h - Fortran programs in what compilers of the time took beyond the standard, and GNU Fortran
 * refuses with any option (rewrite.h). They are compiled from copies in which such statements are
 * rewritten; messages and debugging information name the lines of the original. */
#ifndef DRIVER_DIALECT_H
#define DRIVER_DIALECT_H
#include "nx_api/driver/arguments.h"

/* Runs the command for gcc (command.h), which compiles Fortran files of the user's, and once more from
 * copies if it fails for such statements alone or among others. What fails for an operator of its own is
 * compiled without DEC's structures. Returns gcc's exit status. */
int dialect_run(const char **gcc, const struct arguments *user);

#endif
