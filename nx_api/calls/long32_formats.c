/* long32_formats.c - printf, scanf and so on for programs whose long has 32 bits (nxcc --long32). In such a
 * program's format %ld means 32 bits, so %ld becomes %d; what means 64 bits, %lld, %zd, %lf, stays. Programs
 * reach node_long32_NAME as NAME.
 */
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "backend_node.h"

/* The end of the %[...] that begins at p. */
static const char *end_of_set(const char *p)
{
    p += p[1] == '^' ? 2 : 1;
    p += *p == ']';
    while (*p && *p != ']')
        p++;
    return p;
}

/* The format with %d for %ld, to be freed. scans: the format may have sets. */
static char *narrowed(const char *format, bool scans)
{
    char *copy = malloc(strlen(format) + 1), *to = copy;
    bool in_conversion = false;
    if (!copy)
        abort();
    for (const char *p = format; *p; *to++ = *p++) {
        if (!in_conversion) {
            in_conversion = *p == '%';
            continue;
        }
        if (scans && *p == '[') {
            for (const char *end = end_of_set(p); p < end;)
                *to++ = *p++;
            if (!*p)
                break;
        } else if (p[0] == 'l' && p[1] && strchr("diouxXn", p[1])) {
            p++;
        } else if (p[0] == 'l' && p[1] == 'l') {
            *to++ = *p++;
        }
        in_conversion = strchr("0123456789#-+ '.*$hlLqjztm", *p);
    }
    *to = 0;
    return copy;
}

/* The C library's own functions, by names that neither programs nor GCC use. */
int libc_vfprintf(FILE *f, int flag, const char *format, va_list ap) __asm__("__vfprintf_chk");
int libc_vsprintf(char *s, int flag, size_t room, const char *format, va_list ap) __asm__("__vsprintf_chk");
int libc_vsnprintf(char *s, size_t n, int flag, size_t room, const char *format,
                   va_list ap) __asm__("__vsnprintf_chk");
#define ANY_ROOM ((size_t)-1)

#define WITH_LIST(name, parameters, scans, call)                                                             \
    int node_long32_##name parameters NX_EXPORT(#name);                                                      \
    int node_long32_##name parameters                                                                        \
    {                                                                                                        \
        char *narrow = narrowed(format, scans);                                                              \
        int result = call;                                                                                   \
        free(narrow);                                                                                        \
        return result;                                                                                       \
    }
#define WITH_DOTS(name, parameters, scans, call)                                                             \
    int node_long32_##name parameters NX_EXPORT(#name);                                                      \
    int node_long32_##name parameters                                                                        \
    {                                                                                                        \
        char *narrow = narrowed(format, scans);                                                              \
        va_list ap;                                                                                          \
        va_start(ap, format);                                                                                \
        int result = call;                                                                                   \
        va_end(ap);                                                                                          \
        free(narrow);                                                                                        \
        return result;                                                                                       \
    }

WITH_DOTS(printf, (const char *format, ...), false, libc_vfprintf(nx_output(), 0, narrow, ap))
WITH_LIST(vprintf, (const char *format, va_list ap), false, libc_vfprintf(nx_output(), 0, narrow, ap))
WITH_DOTS(fprintf, (FILE * f, const char *format, ...), false, libc_vfprintf(f, 0, narrow, ap))
WITH_LIST(vfprintf, (FILE * f, const char *format, va_list ap), false, libc_vfprintf(f, 0, narrow, ap))
WITH_DOTS(sprintf, (char *s, const char *format, ...), false, libc_vsprintf(s, 0, ANY_ROOM, narrow, ap))
WITH_LIST(vsprintf, (char *s, const char *format, va_list ap), false,
          libc_vsprintf(s, 0, ANY_ROOM, narrow, ap))
WITH_DOTS(snprintf, (char *s, size_t n, const char *format, ...), false,
          libc_vsnprintf(s, n, 0, ANY_ROOM, narrow, ap))
WITH_LIST(vsnprintf, (char *s, size_t n, const char *format, va_list ap), false,
          libc_vsnprintf(s, n, 0, ANY_ROOM, narrow, ap))
WITH_DOTS(scanf, (const char *format, ...), true, nx_scan_file(nx_input(), narrow, ap))
WITH_DOTS(__isoc99_scanf, (const char *format, ...), true, nx_scan_file(nx_input(), narrow, ap))
WITH_DOTS(fscanf, (FILE * f, const char *format, ...), true, nx_scan_file(f, narrow, ap))
WITH_DOTS(__isoc99_fscanf, (FILE * f, const char *format, ...), true, nx_scan_file(f, narrow, ap))
WITH_DOTS(sscanf, (const char *s, const char *format, ...), true, nx_scan_text(s, narrow, ap))
WITH_DOTS(__isoc99_sscanf, (const char *s, const char *format, ...), true, nx_scan_text(s, narrow, ap))
WITH_LIST(vscanf, (const char *format, va_list ap), true, nx_scan_file(nx_input(), narrow, ap))
WITH_LIST(__isoc99_vscanf, (const char *format, va_list ap), true, nx_scan_file(nx_input(), narrow, ap))
WITH_LIST(vfscanf, (FILE * f, const char *format, va_list ap), true, nx_scan_file(f, narrow, ap))
WITH_LIST(__isoc99_vfscanf, (FILE * f, const char *format, va_list ap), true, nx_scan_file(f, narrow, ap))
WITH_LIST(vsscanf, (const char *s, const char *format, va_list ap), true, nx_scan_text(s, narrow, ap))
WITH_LIST(__isoc99_vsscanf, (const char *s, const char *format, va_list ap), true,
          nx_scan_text(s, narrow, ap))
