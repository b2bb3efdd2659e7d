/* long32.c - the C library for programs whose long has 32 bits (nxcc --long32). The loader binds a program's NAME to
 * long32_NAME where there is one.
 *
 * What printf, scanf and their kin do is up to a format, and there %ld means the program's long. So it is made %d, which
 * is as wide; what is 64 bits wide, %lld, %zd, %lf, is left alone.
 */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "node/libc_parts.h"
#include "node/node.h"

/* The end of the %[...] that begins at p. */
static const char *end_of_set(const char *p)
{
    p += p[1] == '^' ? 2 : 1;
    p += *p == ']';
    while (*p && *p != ']')
        p++;
    return p;
}

/* The format with %ld as %d, for free(). scans: sets may be in it. */
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

#define WITH_LIST(name, parameters, scans, call)                                                             \
    int node_long32_##name parameters                                                                        \
    {                                                                                                        \
        char *narrow = narrowed(format, scans);                                                              \
        int result = call;                                                                                   \
        free(narrow);                                                                                        \
        return result;                                                                                       \
    }
#define WITH_DOTS(name, parameters, scans, call)                                                             \
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

#pragma GCC diagnostic ignored "-Wformat-nonliteral"
#define OUT node_self()->libc->streams.out
#define IN node_self()->libc->streams.in

WITH_DOTS(printf, (const char *format, ...), false, vfprintf(OUT, narrow, ap))
WITH_LIST(vprintf, (const char *format, va_list ap), false, vfprintf(OUT, narrow, ap))
WITH_DOTS(fprintf, (FILE * f, const char *format, ...), false, vfprintf(f, narrow, ap))
WITH_LIST(vfprintf, (FILE * f, const char *format, va_list ap), false, vfprintf(f, narrow, ap))
WITH_DOTS(sprintf, (char *s, const char *format, ...), false, vsprintf(s, narrow, ap))
WITH_LIST(vsprintf, (char *s, const char *format, va_list ap), false, vsprintf(s, narrow, ap))
WITH_DOTS(snprintf, (char *s, size_t n, const char *format, ...), false, vsnprintf(s, n, narrow, ap))
WITH_LIST(vsnprintf, (char *s, size_t n, const char *format, va_list ap), false, vsnprintf(s, n, narrow, ap))
WITH_DOTS(scanf, (const char *format, ...), true, vfscanf(IN, narrow, ap))
WITH_DOTS(__isoc99_scanf, (const char *format, ...), true, vfscanf(IN, narrow, ap))
WITH_DOTS(fscanf, (FILE * f, const char *format, ...), true, vfscanf(f, narrow, ap))
WITH_DOTS(__isoc99_fscanf, (FILE * f, const char *format, ...), true, vfscanf(f, narrow, ap))
WITH_DOTS(sscanf, (const char *s, const char *format, ...), true, vsscanf(s, narrow, ap))
WITH_DOTS(__isoc99_sscanf, (const char *s, const char *format, ...), true, vsscanf(s, narrow, ap))

time_t node_time(time_t *t);

/* time_t is such a program's long. */
int node_long32_time(int *t)
{
    int now = (int)node_time(NULL);
    if (t)
        *t = now;
    return now;
}
