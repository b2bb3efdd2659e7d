/* help.h - what nxcc tells of itself. */
#ifndef DRIVER_HELP_H
#define DRIVER_HELP_H

/* All end the program. */
_Noreturn void help_show(void);
/* The options as lines for programs, as touchstone --describe writes them (sim/cli/describe.h). */
_Noreturn void help_describe(void);
_Noreturn void help_version(void);

#endif
