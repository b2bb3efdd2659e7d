/* help.h - what nxcc tells of itself. */
#ifndef DRIVER_HELP_H
#define DRIVER_HELP_H

/* Both end the program. */
_Noreturn void help_show(void);
_Noreturn void help_version(void);

#endif
