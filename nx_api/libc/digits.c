/* digits.c - numbers as digits, in memory of the program's own. */
#include <stdlib.h>

static char digits[400];

char *ecvt(double x, int count, int *point, int *sign)
{
    return ecvt_r(x, count, point, sign, digits, sizeof digits) ? NULL : digits;
}

char *fcvt(double x, int count, int *point, int *sign)
{
    return fcvt_r(x, count, point, sign, digits, sizeof digits) ? NULL : digits;
}
