/* narrow.c - see narrow.h. In the format of a program whose long has 32 bits %ld means that; so it is made %d, which is as
 * wide. What is 64 bits wide, %lld, %zd, %lf, is left alone. */
#include "nx_api/calls/narrow.h"
#include <stdlib.h>
#include <string.h>

/* The end of the %[...] that begins at p. */
static const char *end_of_set(const char *p)
{
    p += p[1] == '^' ? 2 : 1;
    p += *p == ']';
    while (*p && *p != ']')
        p++;
    return p;
}

char *nx_narrowed(const char *format, bool scans)
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
