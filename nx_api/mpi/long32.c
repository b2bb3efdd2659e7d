/* long32.c - for programs whose long has 32 bits (nxcc --mpi --long32): linked, with narrow.c, into their libnx_long32.a
 * only. */
#include <dlfcn.h>
#include <stdlib.h>
#include <time.h>
#include "nx_api/calls/call.h"
#include "nx_api/calls/narrow.h"
#include "nx_api/mpi/files.h"

int node_long_bytes = 4;
/* Files compiled with --long32 refer to it (nxcc/long32.cc), so that they are linked with it. */
__attribute__((visibility("default"))) const char compiled_with_long32_so_link_with_long32;

FILE *nx_output(void)
{
    return stdout;
}

FILE *nx_input(void)
{
    return stdin;
}

/* The host's, behind this program's. */
static void *next(const char *name)
{
    void *f = dlsym(RTLD_NEXT, name);
    if (!f)
        abort();
    return f;
}

int nx_scan_file(FILE *f, const char *format, va_list ap)
{
    int (*scan)(FILE *, const char *, va_list) = next("__isoc99_vfscanf");
    return scan(f, format, ap);
}

int nx_scan_text(const char *s, const char *format, va_list ap)
{
    int (*scan)(const char *, const char *, va_list) = next("__isoc99_vsscanf");
    return scan(s, format, ap);
}

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

#define OFFSET_CALL(name, served, buffer, face)                                                              \
    __attribute__((visibility("default"))) long node_long32_##name(word fd, int64_t offset, buffer buf,      \
                                                                   size_word len) __asm__(#name);            \
    long node_long32_##name(word fd, int64_t offset, buffer buf, size_word len)                              \
    {                                                                                                        \
        struct node *n = node_self();                                                                        \
        node_enter(n, #name);                                                                                \
        return face(n, served(fd, (word)offset, (word)(offset >> 32), buf, len));                            \
    }
#define OFFSET_CALLS(name, buffer)                                                                           \
    OFFSET_CALL(name, nxs_##name, buffer, nx_plain) OFFSET_CALL(_##name, nxs_##name, buffer, nx_returning)

OFFSET_CALLS(readoff, void *)
OFFSET_CALLS(writeoff, const void *)
OFFSET_CALLS(ireadoff, void *)
OFFSET_CALLS(iwriteoff, const void *)
