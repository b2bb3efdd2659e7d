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
#include "nx_api/calls/narrow.h"

#define WITH_LIST(name, parameters, scans, call)                                                             \
    int node_long32_##name parameters                                                                        \
    {                                                                                                        \
        char *narrow = nx_narrowed(format, scans);                                                           \
        int result = call;                                                                                   \
        free(narrow);                                                                                        \
        return result;                                                                                       \
    }
#define WITH_DOTS(name, parameters, scans, call)                                                             \
    int node_long32_##name parameters                                                                        \
    {                                                                                                        \
        char *narrow = nx_narrowed(format, scans);                                                           \
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
