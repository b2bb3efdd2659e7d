/* command.h - the command that compiles or links what the user asks for: gcc, with the user's arguments
 * among those that make of it a program for simulated nodes; or for a cluster (--mpi). */
#ifndef DRIVER_COMMAND_H
#define DRIVER_COMMAND_H
#include "nx_api/driver/arguments.h"
#include "nx_api/driver/places.h"

/* Ends with NULL, for execvp. Files are all Fortran, or none is. link: what is compiled is linked, too. */
const char **command(const struct arguments *user, const struct places *p, bool link);

#endif
