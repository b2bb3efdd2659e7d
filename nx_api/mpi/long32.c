/* long32.c - for programs whose long has 32 bits (nxcc --mpi --long32): linked into their libnx_long32.a only. What
 * printf, scanf and their kin do is up to a format, and there %ld means the program's long: narrow.h. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "nx_api/calls/call.h"
#include "nx_api/calls/narrow.h"
#include "nx_api/mpi/files.h"

int node_long_bytes = 4;
/* Files compiled with --long32 refer to it (nxcc/long32.cc), so that they are linked with it. */
__attribute__((visibility("default"))) const char nxc_long_has_4_bytes;

/* The C library's own, by names that programs do not use, and that GCC does not know for what it knows. */
int libc_vfprintf(FILE *f, int flag, const char *format, va_list ap) __asm__("__vfprintf_chk");
int libc_vsprintf(char *s, int flag, size_t room, const char *format, va_list ap) __asm__("__vsprintf_chk");
int libc_vsnprintf(char *s, size_t n, int flag, size_t room, const char *format,
                   va_list ap) __asm__("__vsnprintf_chk");
int libc_vfscanf(FILE *f, const char *format, va_list ap) __asm__("__isoc99_vfscanf");
int libc_vsscanf(const char *s, const char *format, va_list ap) __asm__("__isoc99_vsscanf");
#define ANY_ROOM ((size_t)-1)

#define WITH_LIST(name, parameters, scans, call)                                                             \
    int node_long32_##name parameters NX_EXPORT(#name);                                                      \
    int node_long32_##name parameters                                                                        \
    {                                                                                                        \
        char *narrow = nx_narrowed(format, scans);                                                           \
        int result = call;                                                                                   \
        free(narrow);                                                                                        \
        return result;                                                                                       \
    }
#define WITH_DOTS(name, parameters, scans, call)                                                             \
    int node_long32_##name parameters NX_EXPORT(#name);                                                      \
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

WITH_DOTS(printf, (const char *format, ...), false, libc_vfprintf(stdout, 0, narrow, ap))
WITH_LIST(vprintf, (const char *format, va_list ap), false, libc_vfprintf(stdout, 0, narrow, ap))
WITH_DOTS(fprintf, (FILE * f, const char *format, ...), false, libc_vfprintf(f, 0, narrow, ap))
WITH_LIST(vfprintf, (FILE * f, const char *format, va_list ap), false, libc_vfprintf(f, 0, narrow, ap))
WITH_DOTS(sprintf, (char *s, const char *format, ...), false, libc_vsprintf(s, 0, ANY_ROOM, narrow, ap))
WITH_LIST(vsprintf, (char *s, const char *format, va_list ap), false,
          libc_vsprintf(s, 0, ANY_ROOM, narrow, ap))
WITH_DOTS(snprintf, (char *s, size_t n, const char *format, ...), false,
          libc_vsnprintf(s, n, 0, ANY_ROOM, narrow, ap))
WITH_LIST(vsnprintf, (char *s, size_t n, const char *format, va_list ap), false,
          libc_vsnprintf(s, n, 0, ANY_ROOM, narrow, ap))
WITH_DOTS(scanf, (const char *format, ...), true, libc_vfscanf(stdin, narrow, ap))
WITH_DOTS(__isoc99_scanf, (const char *format, ...), true, libc_vfscanf(stdin, narrow, ap))
WITH_DOTS(fscanf, (FILE * f, const char *format, ...), true, libc_vfscanf(f, narrow, ap))
WITH_DOTS(__isoc99_fscanf, (FILE * f, const char *format, ...), true, libc_vfscanf(f, narrow, ap))
WITH_DOTS(sscanf, (const char *s, const char *format, ...), true, libc_vsscanf(s, narrow, ap))
WITH_DOTS(__isoc99_sscanf, (const char *s, const char *format, ...), true, libc_vsscanf(s, narrow, ap))

/* time_t is such a program's long. */
int node_long32_time(int *t) NX_EXPORT("time");
int node_long32_time(int *t)
{
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    if (t)
        *t = (int)now.tv_sec;
    return (int)now.tv_sec;
}

/* An esize_t is a word of 64 bits. These take precedence over those of files.c, which are weak. */
#define SIZE_CALL(name, f, face)                                                                             \
    __attribute__((visibility("default")))                                                                   \
    int64_t node_long32_##name(int fd, int64_t offset, int whence) __asm__(#name);                           \
    int64_t node_long32_##name(int fd, int64_t offset, int whence)                                           \
    {                                                                                                        \
        return files_size(#name, f, face, fd, offset, whence);                                               \
    }

SIZE_CALL(eseek, files_seek, nx_plain)
SIZE_CALL(_eseek, files_seek, nx_returning)
SIZE_CALL(esize, files_resize, nx_plain)
SIZE_CALL(_esize, files_resize, nx_returning)
