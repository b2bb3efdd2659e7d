/* help.h - what nxcc tells of itself. */
#ifndef DRIVER_HELP_H
#define DRIVER_HELP_H
#include <stdbool.h>

/* Of nxcc's own options with two dashes the one that is most like a misspelt one; NULL: none is like it. */
const char *help_nearest(const char *option);

/* All end the program. */
_Noreturn void help_show(void);
/* The options as lines for programs, as touchstone --describe writes them (sim/cli/describe.h). */
_Noreturn void help_describe(void);
/* By MPI's names GCC comes first, which is what makefiles and configure scripts want to know. */
_Noreturn void help_version(bool mpi);

#endif
