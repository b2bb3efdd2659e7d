/* narrow.h - what narrow.c needs of what serves the calls: the standard streams of the program that calls, and the C library's own
 * vfscanf and vsscanf, of C99, which a program reaches by names that are narrow.c's. */
#ifndef CALLS_NARROW_H
#define CALLS_NARROW_H
#include <stdarg.h>
#include <stdio.h>

FILE *nx_output(void);
FILE *nx_input(void);
int nx_scan_file(FILE *f, const char *format, va_list ap);
int nx_scan_text(const char *s, const char *format, va_list ap);

#endif
