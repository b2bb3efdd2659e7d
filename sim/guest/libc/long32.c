/* long32.c - the C library for programs whose long has 32 bits (nxcc --long32). The loader binds a
 * program's NAME to node_long32_NAME if that exists. The calls that read or write by a format are in
 * nx_api/calls/long32_formats.c. */
#include <time.h>
#include <unistd.h>
#include "guest/libc/libc_parts.h"
#include "node/node.h"
#include "nx_api/contract/backend.h"
#include "node/self.h"

FILE *nx_output(void)
{
    return stream_standard(node_self(), STDOUT_FILENO);
}

FILE *nx_input(void)
{
    return stream_standard(node_self(), STDIN_FILENO);
}

int nx_scan_file(FILE *f, const char *format, va_list ap)
{
    return vfscanf(f, format, ap);
}

int nx_scan_text(const char *s, const char *format, va_list ap)
{
    return vsscanf(s, format, ap);
}

time_t node_time(time_t *t);

/* time_t is a long, too, so it has 32 bits in such a program. */
int node_long32_time(int *t)
{
    int now = (int)node_time(NULL);
    if (t)
        *t = now;
    return now;
}
