/* stdio.c - the stdio calls that name no stream, that open or close a stream, or that act on names of
 * files. All other stdio calls are the host's, on the node's own streams. A function node_NAME serves a
 * node program's NAME. */
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "guest/libc/file.h"
#include "guest/libc/libc_parts.h"
#include "node/node.h"
#include "node/self.h"

static struct streams *streams(void)
{
    return streams_of(node_self());
}

static FILE *standard(int fd)
{
    return stream_standard(node_self(), fd);
}

/* --- standard output and input --- */

int node_vprintf(const char *format, va_list ap)
{
    return vfprintf(standard(STDOUT_FILENO), format, ap);
}

int node_printf(const char *format, ...)
{
    va_list ap;
    va_start(ap, format);
    int r = vfprintf(standard(STDOUT_FILENO), format, ap);
    va_end(ap);
    return r;
}

int node_putchar(int c)
{
    return putc(c, standard(STDOUT_FILENO));
}

int node_puts(const char *s)
{
    FILE *out = standard(STDOUT_FILENO);
    return fputs(s, out) == EOF || putc('\n', out) == EOF ? EOF : 1;
}

int node_putchar_unlocked(int c)
{
    return node_putchar(c);
}

int node_getchar_unlocked(void)
{
    return getc(standard(STDIN_FILENO));
}

void node_perror(const char *s)
{
    int why = errno;
    bool named = s != NULL && *s != 0;
    fprintf(standard(STDERR_FILENO), "%s%s%s\n", named ? s : "", named ? ": " : "", node_strerror(why));
}

int node_getchar(void)
{
    return getc(standard(STDIN_FILENO));
}

char *node_gets(char *s)
{
    FILE *in = standard(STDIN_FILENO);
    size_t len = 0;
    int c;
    while ((c = getc(in)) != EOF && c != '\n')
        s[len++] = (char)c;
    s[len] = 0;
    return c == EOF && (len == 0 || ferror(in)) ? NULL : s;
}

int node___isoc99_scanf(const char *format, ...)
{
    va_list ap;
    va_start(ap, format);
    int r = vfscanf(standard(STDIN_FILENO), format, ap);
    va_end(ap);
    return r;
}

/* The scanf of before C99 differs only in GNU's %as. */
int node_scanf(const char *format, ...)
{
    va_list ap;
    va_start(ap, format);
    int r = vfscanf(standard(STDIN_FILENO), format, ap);
    va_end(ap);
    return r;
}

int node_vscanf(const char *format, va_list ap)
{
    return vfscanf(standard(STDIN_FILENO), format, ap);
}

int node___isoc99_vscanf(const char *format, va_list ap)
{
    return vfscanf(standard(STDIN_FILENO), format, ap);
}

/* --- streams --- */

FILE *node_fopen(const char *path, const char *mode)
{
    return stream_fopen(streams(), node_self(), path, mode);
}
FILE *node_tmpfile(void)
{
    return stream_tmpfile(streams(), node_self());
}
int node_fclose(FILE *f)
{
    return stream_fclose(streams(), f);
}

FILE *node_freopen(const char *path, const char *mode, FILE *f)
{
    return stream_freopen(streams(), path, mode, f);
}

FILE *node_fdopen(int fd, const char *mode)
{
    return stream_fdopen(streams(), node_self(), fd, mode);
}

FILE *node_open_memstream(char **text, size_t *size)
{
    return stream_open_memstream(streams(), node_self(), text, size);
}

FILE *node_fmemopen(void *at, size_t size, const char *mode)
{
    return stream_fmemopen(streams(), node_self(), at, size, mode);
}

int node_fileno(FILE *f)
{
    return stream_fileno(streams(), f);
}

/* NULL flushes all streams of the node, and none of the simulator. */
int node_fflush(FILE *f)
{
    if (f != NULL)
        return fflush(f);
    streams_flush(streams());
    return 0;
}

/* --- names: open, unlink and the like are in descriptors.c --- */

int node_remove(const char *path)
{
    struct node *n = node_self();
    int answer = file_unlink(n, path);
    return answer < 0 && errno == EISDIR ? file_remove_folder(n, path) : answer;
}
