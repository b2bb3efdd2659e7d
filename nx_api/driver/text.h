/* text.h - the end when something is wrong, and strings made like printf's. */
#ifndef DRIVER_TEXT_H
#define DRIVER_TEXT_H

/* Says what is wrong, after the name nxcc was called by, and exits with status 1. */
__attribute__((format(printf, 1, 2), noreturn)) void fail(const char *format, ...);
/* The same, when execvp has returned: why, as errno does, and what to do. */
_Noreturn void fail_to_run(const char *program);
/* For free(). */
__attribute__((format(printf, 1, 2))) char *text(const char *format, ...);

#endif
