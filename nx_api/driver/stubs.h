/* stubs.h - linking, with an eye on names that are not there. */
#ifndef DRIVER_STUBS_H
#define DRIVER_STUBS_H
#include "nx_api/driver/arguments.h"

/* Runs gcc, which links the program; its exit status. When names are not there, says that --stubs links them;
 * or if the user has said --stubs, links again with a function for each of them that fails with ENOSYS when
 * it is called, or returns what the user says, and says which. A name that the program uses as a variable is
 * an error. Objects of simulated nodes in a program for a cluster, or the reverse, are named instead of what
 * the linker missed in them. */
int stubs_link(const char **gcc, const struct arguments *user, const char *program);
#endif
