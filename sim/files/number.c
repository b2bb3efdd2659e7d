/* number.c - see number.h. */
#include "files/number.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool number_read(const char *text, double *value, double *unit)
{
    char *end;
    *value = strtod(text, &end);
    if (end == text || *end || !isfinite(*value) || strchr(text, 'x') || strchr(text, 'X'))
        return false;
    const char *power = strpbrk(text, "eE"), *point = strchr(text, '.');
    long digits = point ? (power ? power : end) - point - 1 : 0;
    if (unit)
        *unit = pow(10, (power ? strtod(power + 1, NULL) : 0) - (double)digits);
    return true;
}

struct number_text number_grouped(uint64_t count)
{
    struct number_text grouped = {""};
    char digits[24], *to = grouped.text;
    int length = snprintf(digits, sizeof digits, "%" PRIu64, count);
    for (int i = 0; i < length; i++) {
        if (i && (length - i) % 3 == 0)
            *to++ = ',';
        *to++ = digits[i];
    }
    return grouped;
}
