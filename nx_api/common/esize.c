/* esize.c - the extended arithmetic: 64-bit numbers in two longs, of which the low 32 bits count. */
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include "global.h"
#include "nx.h"

static int64_t from(esize_t a)
{
    return (int64_t)((uint64_t)(uint32_t)a.shigh << 32 | (uint32_t)a.slow);
}

static esize_t to(int64_t x)
{
    return (esize_t){(long)(uint32_t)x, (long)(x >> 32)};
}

/* --- the operations: 0, or what is wrong --- */

static int add(int64_t a, int64_t b, int64_t *result)
{
    return __builtin_add_overflow(a, b, result) ? ERANGE : 0;
}

static int subtract(int64_t a, int64_t b, int64_t *result)
{
    return __builtin_sub_overflow(a, b, result) ? ERANGE : 0;
}

static int multiply(int64_t a, int64_t b, int64_t *result)
{
    return __builtin_mul_overflow(a, b, result) ? ERANGE : 0;
}

static int divide(int64_t a, int64_t n, int64_t *result)
{
    if (n == 0)
        return EINVAL;
    if (n == -1) /* the least number has no opposite */
        return subtract(0, a, result) || *result != (int32_t)*result ? ERANGE : 0;
    *result = a / n;
    return *result == (int32_t)*result ? 0 : ERANGE;
}

static int remainder_of(int64_t a, int64_t n, int64_t *result)
{
    if (n == 0)
        return EINVAL;
    *result = n == -1 ? 0 : a % n;
    return 0;
}

static int read(const char *s, int64_t *result)
{
    char *end;
    if (!s)
        return EQPBUF;
    errno = 0;
    *result = strtoll(s, &end, 10);
    return errno || end == s || *end ? ERANGE : 0;
}

/* --- the calls: NAME and _NAME of each operation --- */

#define CALLS(name, result, give, failed, parameters, operation)                                             \
    result name parameters                                                                                   \
    {                                                                                                        \
        int64_t value;                                                                                       \
        int error = operation;                                                                               \
        if (error)                                                                                           \
            nx_fail(#name, error);                                                                           \
        return give(value);                                                                                  \
    }                                                                                                        \
    result _##name parameters                                                                                \
    {                                                                                                        \
        int64_t value;                                                                                       \
        int error = operation;                                                                               \
        if (!error)                                                                                          \
            return give(value);                                                                              \
        errno = error;                                                                                       \
        return failed;                                                                                       \
    }
#define NOTHING ((esize_t){-1, -1})

CALLS(eadd, esize_t, to, NOTHING, (esize_t a, esize_t b), add(from(a), from(b), &value))
CALLS(esub, esize_t, to, NOTHING, (esize_t a, esize_t b), subtract(from(a), from(b), &value))
CALLS(emul, esize_t, to, NOTHING, (esize_t a, long n), multiply(from(a), (int32_t)n, &value))
CALLS(stoe, esize_t, to, NOTHING, (const char *s), read(s, &value))
CALLS(ediv, long, (long), -1, (esize_t a, long n), divide(from(a), (int32_t)n, &value))
CALLS(emod, long, (long), -1, (esize_t a, long n), remainder_of(from(a), (int32_t)n, &value))

long ecmp(esize_t a, esize_t b)
{
    int64_t x = from(a), y = from(b);
    return (x > y) - (x < y);
}

long _ecmp(esize_t a, esize_t b)
{
    return ecmp(a, b);
}

void etos(esize_t a, char *s)
{
    char digits[20];
    int64_t x = from(a);
    uint64_t rest = x < 0 ? -(uint64_t)x : (uint64_t)x;
    size_t n = 0;
    do
        digits[n++] = (char)('0' + rest % 10);
    while ((rest /= 10) > 0);
    if (x < 0)
        *s++ = '-';
    while (n > 0)
        *s++ = digits[--n];
    *s = '\0';
}

long _etos(esize_t a, char *s)
{
    if (!s)
        return nx_result(EQPBUF);
    etos(a, s);
    return 0;
}
