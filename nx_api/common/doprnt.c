/* doprnt.c - _doprnt, which programs called for what vfprintf does now. */
#include <stdarg.h>
#include <stdio.h>

int _doprnt(const char *format, va_list list, FILE *f);

int _doprnt(const char *format, va_list list, FILE *f)
{
    return vfprintf(f, format, list);
}
