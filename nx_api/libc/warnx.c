/* warnx.c - warnings, as the library of XDR prints them. */
#include <err.h>
#include <stdarg.h>
#include <stdio.h>

void warnx(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vfprintf(stderr, format, list);
    va_end(list);
    fputc('\n', stderr);
}
