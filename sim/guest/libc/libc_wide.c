/* libc_wide.c - wide characters. A node's streams hold bytes, and in the "C" locale a wide character is one
 * byte; so calls that read or write wide characters narrow them first. Formats are narrowed as a whole,
 * since %s and %ls mean the same in both. A function node_NAME serves a node program's NAME. */
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include <wchar.h>
#include "kernel/xalloc.h"
#include "guest/libc/libc_parts.h"
#include "node/node.h"
#include "node/self.h"

static FILE *standard(int fd)
{
    return stream_standard(node_self(), fd);
}

/* The text in bytes, for free(); NULL with errno if a character is not in the "C" locale. */
static char *narrowed(const wchar_t *text)
{
    size_t len = wcstombs(NULL, text, 0);
    char *narrow = len == (size_t)-1 ? NULL : xmalloc(len + 1);
    if (narrow != NULL)
        wcstombs(narrow, text, len + 1);
    return narrow;
}

/* --- formatted --- */

static int print(FILE *f, const wchar_t *format, va_list ap)
{
    char *narrow = narrowed(format);
    int r = narrow ? vfprintf(f, narrow, ap) : -1;
    free(narrow);
    return r;
}

static int scan(FILE *f, const wchar_t *format, va_list ap)
{
    char *narrow = narrowed(format);
    int r = narrow ? vfscanf(f, narrow, ap) : EOF;
    free(narrow);
    return r;
}

#define WITH_LIST(name, parameters, call)                                                                    \
    int node_##name parameters                                                                               \
    {                                                                                                        \
        return call;                                                                                         \
    }
#define WITH_DOTS(name, parameters, call)                                                                    \
    int node_##name parameters                                                                               \
    {                                                                                                        \
        va_list ap;                                                                                          \
        va_start(ap, format);                                                                                \
        int r = call;                                                                                        \
        va_end(ap);                                                                                          \
        return r;                                                                                            \
    }

WITH_DOTS(wprintf, (const wchar_t *format, ...), print(standard(STDOUT_FILENO), format, ap))
WITH_LIST(vwprintf, (const wchar_t *format, va_list ap), print(standard(STDOUT_FILENO), format, ap))
WITH_DOTS(fwprintf, (FILE * f, const wchar_t *format, ...), print(f, format, ap))
WITH_LIST(vfwprintf, (FILE * f, const wchar_t *format, va_list ap), print(f, format, ap))
WITH_DOTS(wscanf, (const wchar_t *format, ...), scan(standard(STDIN_FILENO), format, ap))
WITH_LIST(vwscanf, (const wchar_t *format, va_list ap), scan(standard(STDIN_FILENO), format, ap))
WITH_DOTS(fwscanf, (FILE * f, const wchar_t *format, ...), scan(f, format, ap))
WITH_LIST(vfwscanf, (FILE * f, const wchar_t *format, va_list ap), scan(f, format, ap))
WITH_DOTS(__isoc99_wscanf, (const wchar_t *format, ...), scan(standard(STDIN_FILENO), format, ap))
WITH_LIST(__isoc99_vwscanf, (const wchar_t *format, va_list ap), scan(standard(STDIN_FILENO), format, ap))
WITH_DOTS(__isoc99_fwscanf, (FILE * f, const wchar_t *format, ...), scan(f, format, ap))
WITH_LIST(__isoc99_vfwscanf, (FILE * f, const wchar_t *format, va_list ap), scan(f, format, ap))

/* --- characters and lines --- */

wint_t node_fgetwc(FILE *f)
{
    return btowc(getc(f));
}
wint_t node_getwc(FILE *f)
{
    return node_fgetwc(f);
}
wint_t node_getwchar(void)
{
    return node_fgetwc(standard(STDIN_FILENO));
}

wint_t node_ungetwc(wint_t c, FILE *f)
{
    int byte = wctob(c);
    return byte == EOF || ungetc(byte, f) == EOF ? WEOF : c;
}

wint_t node_fputwc(wchar_t c, FILE *f)
{
    int byte = wctob((wint_t)c);
    if (byte == EOF)
        errno = EILSEQ;
    return byte == EOF || putc(byte, f) == EOF ? WEOF : (wint_t)c;
}
wint_t node_putwc(wchar_t c, FILE *f)
{
    return node_fputwc(c, f);
}
wint_t node_putwchar(wchar_t c)
{
    return node_fputwc(c, standard(STDOUT_FILENO));
}

int node_fputws(const wchar_t *s, FILE *f)
{
    char *narrow = narrowed(s);
    int r = narrow ? fputs(narrow, f) : EOF;
    free(narrow);
    return r;
}

wchar_t *node_fgetws(wchar_t *s, int room, FILE *f)
{
    int len = 0;
    wint_t c = 0;
    while (len < room - 1 && c != L'\n' && (c = node_fgetwc(f)) != WEOF)
        s[len++] = (wchar_t)c;
    if (room <= 0 || (len == 0 && c == WEOF))
        return NULL;
    s[len] = 0;
    return s;
}

/* A stream takes both bytes and wide characters. */
int node_fwide(FILE *f, int to)
{
    (void)f;
    return to;
}

/* --- conversions, which use the node's own state if the program passes none --- */

static mbstate_t *state(mbstate_t *of)
{
    return of ? of : &libc_of(node_self())->multibyte;
}

size_t node_mbrlen(const char *s, size_t n, mbstate_t *of)
{
    return mbrlen(s, n, state(of));
}
size_t node___mbrlen(const char *s, size_t n, mbstate_t *of)
{
    return node_mbrlen(s, n, of);
}
size_t node_mbrtowc(wchar_t *to, const char *s, size_t n, mbstate_t *of)
{
    return mbrtowc(to, s, n, state(of));
}
size_t node_wcrtomb(char *to, wchar_t c, mbstate_t *of)
{
    return wcrtomb(to, c, state(of));
}
size_t node_mbsrtowcs(wchar_t *to, const char **s, size_t n, mbstate_t *of)
{
    return mbsrtowcs(to, s, n, state(of));
}
size_t node_wcsrtombs(char *to, const wchar_t **s, size_t n, mbstate_t *of)
{
    return wcsrtombs(to, s, n, state(of));
}
