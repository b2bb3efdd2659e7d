/* number.c - see number.h. */
#include "files/number.h"
#include <math.h>
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
