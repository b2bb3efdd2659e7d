/* text.h - the end when something is wrong, and strings made like printf's. */
#ifndef DRIVER_TEXT_H
#define DRIVER_TEXT_H

/* Says what is wrong, after the name nxcc was called by, and exits with status 1. */
__attribute__((format(printf, 1, 2), noreturn)) void fail(const char *format, ...);
/* For free(). */
__attribute__((format(printf, 1, 2))) char *text(const char *format, ...);

#endif
