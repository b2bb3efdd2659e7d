/* text.c - see text.h. */
#include "nx_api/driver/text.h"
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void fail(const char *format, ...)
{
    va_list list;
    fprintf(stderr, "%s: ", program_invocation_short_name);
    va_start(list, format);
    vfprintf(stderr, format, list);
    va_end(list);
    fputc('\n', stderr);
    exit(1);
}

char *text(const char *format, ...)
{
    char *s;
    va_list list;
    va_start(list, format);
    if (vasprintf(&s, format, list) < 0)
        fail("out of memory");
    va_end(list);
    return s;
}

_Noreturn void fail_to_run(const char *program)
{
    if (errno == ENOENT && (!strcmp(program, NXCC_GCC) || !strcmp(program, NXCC_GXX)))
        fail("%s is not to be found; nxcc has been built for this version of GCC: install it (in Debian, the "
             "package of that name)",
             program);
    fail("%s: %s", program, strerror(errno));
}

void text_list(char **list, const char *word)
{
    char *longer = *list ? text("%s, %s", *list, word) : text("%s", word);
    free(*list);
    *list = longer;
}

bool is_one_of(const char *word, const char *const *list)
{
    for (; *list; list++)
        if (!strcmp(word, *list))
            return true;
    return false;
}
