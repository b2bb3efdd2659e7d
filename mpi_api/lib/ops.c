/* ops.c - the operations of reductions: MPI's own element by element, the program's as functions. */
#include <complex.h>
#include <stdlib.h>
#include "tasks.h"

/* --- MPI's own --- */

#define LOOP(type, expression)                                                                               \
    do {                                                                                                     \
        const type *x = in;                                                                                  \
        type *y = inout;                                                                                     \
        for (size_t i = 0; i < n; i++)                                                                       \
            y[i] = (type)(expression);                                                                       \
    } while (0)

#define BETWEEN(type)                                                                                        \
    case SUM_NUMBER:                                                                                         \
        LOOP(type, x[i] + y[i]);                                                                             \
        break;                                                                                               \
    case PROD_NUMBER:                                                                                        \
        LOOP(type, x[i] * y[i]);                                                                             \
        break;

#define ORDERED(type)                                                                                        \
    case MIN_NUMBER:                                                                                         \
        LOOP(type, x[i] < y[i] ? x[i] : y[i]);                                                               \
        break;                                                                                               \
    case MAX_NUMBER:                                                                                         \
        LOOP(type, x[i] > y[i] ? x[i] : y[i]);                                                               \
        break;

#define LOGICALLY(type)                                                                                      \
    case LAND_NUMBER:                                                                                        \
        LOOP(type, x[i] && y[i]);                                                                            \
        break;                                                                                               \
    case LOR_NUMBER:                                                                                         \
        LOOP(type, x[i] || y[i]);                                                                            \
        break;                                                                                               \
    case LXOR_NUMBER:                                                                                        \
        LOOP(type, !x[i] != !y[i]);                                                                          \
        break;

#define BITWISE(type)                                                                                        \
    case BAND_NUMBER:                                                                                        \
        LOOP(type, x[i] & y[i]);                                                                             \
        break;                                                                                               \
    case BOR_NUMBER:                                                                                         \
        LOOP(type, x[i] | y[i]);                                                                             \
        break;                                                                                               \
    case BXOR_NUMBER:                                                                                        \
        LOOP(type, x[i] ^ y[i]);                                                                             \
        break;

enum number {
    SUM_NUMBER = 0x21,
    MIN_NUMBER = 0x22,
    MAX_NUMBER = 0x23,
    PROD_NUMBER = 0x24,
    BAND_NUMBER = 0x28,
    BOR_NUMBER = 0x29,
    BXOR_NUMBER = 0x2a,
    LAND_NUMBER = 0x30,
    LOR_NUMBER = 0x31,
    LXOR_NUMBER = 0x32,
    MINLOC_NUMBER = 0x38,
    MAXLOC_NUMBER = 0x39,
    REPLACE_NUMBER = 0x3c,
    NO_OP_NUMBER = 0x3d
};

#define FUNCTION(name, type, ...)                                                                            \
    static void name(int number, const void *in, void *inout, size_t n)                                      \
    {                                                                                                        \
        switch (number) {                                                                                    \
            __VA_ARGS__                                                                                      \
        default:                                                                                             \
            break;                                                                                           \
        }                                                                                                    \
    }
#define WHOLES(name, type) FUNCTION(name, type, BETWEEN(type) ORDERED(type) LOGICALLY(type) BITWISE(type))
WHOLES(on_int8, int8_t)
WHOLES(on_int16, int16_t)
WHOLES(on_int32, int32_t)
WHOLES(on_int64, int64_t)
WHOLES(on_int128, __int128)
WHOLES(on_uint8, uint8_t)
WHOLES(on_uint16, uint16_t)
WHOLES(on_uint32, uint32_t)
WHOLES(on_uint64, uint64_t)
#define REALS(name, type) FUNCTION(name, type, BETWEEN(type) ORDERED(type) LOGICALLY(type))
REALS(on_float, float)
REALS(on_double, double)
REALS(on_long_double, long double)
REALS(on_quad, _Float128)
#define COMPLEXES(name, type) FUNCTION(name, type, BETWEEN(type))
COMPLEXES(on_complex, float complex)
COMPLEXES(on_double_complex, double complex)
COMPLEXES(on_long_double_complex, long double complex)
COMPLEXES(on_quad_complex, _Complex _Float128)

/* The first of equal values has the smaller index. */
#define PAIRS(name, value_type, index_type)                                                                  \
    static void name(int number, const void *in, void *inout, size_t n)                                      \
    {                                                                                                        \
        struct pair {                                                                                        \
            value_type value;                                                                                \
            index_type index;                                                                                \
        };                                                                                                   \
        const struct pair *x = in;                                                                           \
        struct pair *y = inout;                                                                              \
        for (size_t i = 0; i < n; i++) {                                                                     \
            bool less = number == MINLOC_NUMBER ? x[i].value < y[i].value : x[i].value > y[i].value;         \
            if (less || (x[i].value == y[i].value && x[i].index < y[i].index))                               \
                y[i] = x[i];                                                                                 \
        }                                                                                                    \
    }
PAIRS(on_float_int, float, int)
PAIRS(on_double_int, double, int)
PAIRS(on_long_int, long, int)
PAIRS(on_2int, int, int)
PAIRS(on_short_int, short, int)
PAIRS(on_long_double_int, long double, int)
PAIRS(on_2real, float, float)
PAIRS(on_2double, double, double)

typedef void function_on(int number, const void *in, void *inout, size_t n);

static function_on *pair_function(MPI_Datatype t)
{
    switch ((uintptr_t)t) {
    case 0x228:
        return on_float_int;
    case 0x229:
        return on_double_int;
    case 0x22a:
        return on_long_int;
    case 0x22c:
        return on_short_int;
    case 0x22d:
        return on_long_double_int;
    case 0x230:
        return on_2real;
    case 0x231:
        return on_2double;
    default:
        return on_2int;
    }
}

static function_on *of_bytes(int bytes, function_on *one, function_on *two, function_on *four,
                             function_on *eight)
{
    return bytes == 1 ? one : bytes == 2 ? two : bytes == 4 ? four : eight;
}

/* Fortran's REAL(16) has 113 bits, C's long double 64. */
static function_on *real_function(MPI_Datatype t, int bytes)
{
    return bytes == 4 ? on_float : bytes == 8 ? on_double : t == MPI_REAL16 ? on_quad : on_long_double;
}

static function_on *complex_function(MPI_Datatype t, int bytes)
{
    return bytes == 8           ? on_complex
           : bytes == 16        ? on_double_complex
           : t == MPI_COMPLEX32 ? on_quad_complex
                                : on_long_double_complex;
}

static function_on *function_of(MPI_Datatype t, const struct basic *b)
{
    switch (b->class) {
    case WHOLE:
        return b->bytes == 16 ? on_int128 : of_bytes(b->bytes, on_int8, on_int16, on_int32, on_int64);
    case LOGICAL:
        return of_bytes(b->bytes, on_uint8, on_uint16, on_int32, on_int64);
    case REAL:
        return real_function(t, b->bytes);
    case COMPLEX:
        return complex_function(t, b->bytes);
    case PAIR:
        return pair_function(t);
    default:
        return of_bytes(b->bytes, on_uint8, on_uint16, on_uint32, on_uint64);
    }
}

bool op_is_own(MPI_Op op)
{
    uintptr_t n = (uintptr_t)op;
    return (n >= 0x21 && n <= 0x24) || (n >= 0x28 && n <= 0x2a) || (n >= 0x30 && n <= 0x32) || n == 0x38 ||
           n == 0x39 || n == 0x3c || n == 0x3d;
}

/* The classes that an operation of MPI's is for, as bits. */
static unsigned classes_of(uintptr_t op)
{
    const unsigned numbers = 1 << WHOLE | 1 << NATURAL | 1 << REAL;
    if (op == MINLOC_NUMBER || op == MAXLOC_NUMBER)
        return 1 << PAIR;
    if (op == SUM_NUMBER || op == PROD_NUMBER)
        return numbers | 1 << COMPLEX;
    if (op == MIN_NUMBER || op == MAX_NUMBER)
        return numbers;
    if (op >= LAND_NUMBER && op <= LXOR_NUMBER)
        return 1 << WHOLE | 1 << NATURAL | 1 << LOGICAL | 1 << REAL;
    if (op >= BAND_NUMBER && op <= BXOR_NUMBER)
        return 1 << WHOLE | 1 << NATURAL | 1 << BITS | 1 << LOGICAL;
    return 0;
}

const char *op_refuses(MPI_Op op, MPI_Datatype t)
{
    const struct basic *b = type_basic(t);
    if (!op_is_own(op))
        return object_of(op, OP) ? NULL : "the operation is null, or freed";
    if (!b)
        return "an operation of MPI's own is for MPI's own datatypes: for others there is MPI_Op_create";
    if (!(classes_of((uintptr_t)op) & 1u << b->class))
        return op == MPI_REPLACE || op == MPI_NO_OP ? "the operation is for accesses to windows only"
                                                    : "the operation is not for this datatype";
    return NULL;
}

/* --- both --- */

struct application {
    MPI_User_function *function;
    void *in, *inout;
    int count;
    MPI_Datatype type;
};

static void apply(void *application)
{
    struct application *a = application;
    a->function(a->in, a->inout, &a->count, &a->type);
}

static RUN_SELDOM void apply_in_task(const struct op *own, void *in, void *inout, int count, MPI_Datatype t)
{
    tasks_call(apply, &(struct application){own->function, in, inout, count, t});
}

void op_apply(MPI_Op op, void *in, void *inout, int count, MPI_Datatype t)
{
    struct op *own = op_is_own(op) ? NULL : object_of(op, OP);
    if (own && tasks_under_way) {
        apply_in_task(own, in, inout, count, t);
    } else if (own) {
        own->function(in, inout, &count, &t);
    } else if (op == MPI_REPLACE) {
        type_copy(in, count, t, inout, count, t);
    } else if (op != MPI_NO_OP) {
        function_of(t, type_basic(t))((int)(uintptr_t)op, in, inout, (size_t)count);
    }
}

bool op_commutes(MPI_Op op)
{
    const struct op *own = op_is_own(op) ? NULL : object_of(op, OP);
    return own ? own->commutes : op != MPI_REPLACE && op != MPI_NO_OP;
}

void op_keep(MPI_Op op)
{
    struct op *own = object_of(op, OP);
    if (own)
        own->object.users++;
}

void op_leave(MPI_Op op)
{
    struct op *own = object_of(op, OP);
    if (own && object_leave(&own->object))
        free(own);
}

/* --- the calls --- */

CALL(Op_create, (MPI_User_function * function, int commutes, MPI_Op *op))
{
    if (!function)
        return fail(NULL, CALL_Op_create, MPI_ERR_ARG, "the function is a null pointer");
    struct op *o = object_new(OP, sizeof *o);
    o->function = function, o->commutes = commutes != 0;
    *op = HANDLE(MPI_Op, o);
    return MPI_SUCCESS;
}

CALL(Op_free, (MPI_Op * op))
{
    if (!object_of(*op, OP))
        return fail(NULL, CALL_Op_free, MPI_ERR_OP, "the operation is null, freed, or MPI's own");
    op_leave(*op);
    *op = MPI_OP_NULL;
    return MPI_SUCCESS;
}

CALL(Op_commutative, (MPI_Op op, int *commutes))
{
    if (!op_is_own(op) && !object_of(op, OP))
        return fail(NULL, CALL_Op_commutative, MPI_ERR_OP, "the operation is null, or freed");
    *commutes = op_commutes(op);
    return MPI_SUCCESS;
}

CALL(Reduce_local, (const void *in, void *inout, int count, MPI_Datatype type, MPI_Op op))
{
    const char *refuses = op_refuses(op, type);
    if (count < 0)
        return fail(NULL, CALL_Reduce_local, MPI_ERR_COUNT, "the count %d is negative", count);
    if (!type_of(type))
        return type_missing(CALL_Reduce_local);
    if (refuses)
        return fail(NULL, CALL_Reduce_local, MPI_ERR_OP, "%s", refuses);
    if (in == MPI_IN_PLACE || inout == MPI_IN_PLACE)
        return fail(NULL, CALL_Reduce_local, MPI_ERR_BUFFER, "MPI_IN_PLACE is no buffer of this call");
    if (in == inout && count > 0)
        return fail(NULL, CALL_Reduce_local, MPI_ERR_BUFFER, "the two buffers are the same memory");
    op_apply(op, (void *)(uintptr_t)in, inout, count, type);
    return MPI_SUCCESS;
}
