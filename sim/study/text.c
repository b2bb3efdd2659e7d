/* text.c - see text.h. */
#include "study/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

char *text_of(const char *format, ...)
{
    char *text;
    va_list args;
    va_start(args, format);
    if (vasprintf(&text, format, args) < 0)
        abort();
    va_end(args);
    return text;
}
