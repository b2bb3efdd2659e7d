/* mpi_long32.c - for programs whose long has 32 bits (nxcc --mpi --long32). Only libnx_long32.a has this
 * file, and long32_formats.c and long32_calls.c. */
#include <dlfcn.h>
#include <stdlib.h>
#include <time.h>
#include "nx_api/mpi/mpi_node.h"

int mpi_long_bytes = 4;
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

/* The host's function of a name that this program defines, too. */
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

/* Such a program's time_t has 32 bits. */
int node_long32_time(int *t) NX_EXPORT("time");
int node_long32_time(int *t)
{
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    if (t)
        *t = (int)now.tv_sec;
    return (int)now.tv_sec;
}
