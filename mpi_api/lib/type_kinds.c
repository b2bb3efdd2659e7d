/* type_kinds.c - datatypes for Fortran's numbers of at least so many digits and such a range: of the kinds
 * that selected_real_kind and selected_int_kind choose. They are MPI's own: each of them is there once, and
 * never freed. */
#include <string.h>
#include "types.h"

static int made;

static MPI_Datatype handle_of(int i)
{
    return (MPI_Datatype)(uintptr_t)(FIRST_BASIC + NAMED + i);
}

/* What a program has asked for. */
struct asked {
    int call, combiner;
    int ints, list[2];
};

static bool is_asked(const struct type *t, const struct asked *a)
{
    return t->combiner == a->combiner && !memcmp(t->int_list, a->list, (size_t)a->ints * sizeof *a->list);
}

/* Elements are as those of another type of MPI's own; NULL: there are none of this kind. */
static int make(const struct asked *a, MPI_Datatype like, MPI_Datatype *type)
{
    if (!like)
        return fail(NULL, a->call, MPI_ERR_ARG, "Fortran has no numbers of so many digits, or of this range");
    for (int i = 0; i < made; i++)
        if (is_asked(type_of(handle_of(i)), a))
            return *type = handle_of(i), MPI_SUCCESS;
    if (made == MOST_KINDS)
        return fail(NULL, a->call, MPI_ERR_INTERN, "there are %d of these datatypes already", made);
    basic_types[NAMED + made] = *type_basic(like);
    *type = handle_of(made++);
    struct type *t = type_of(*type);
    type_made_of(t, a->ints, 0, 0);
    memcpy(t->int_list, a->list, (size_t)a->ints * sizeof *a->list);
    t->combiner = a->combiner;
    return MPI_SUCCESS;
}

/* The kinds that gfortran has. It is not asked for what is MPI_UNDEFINED, a negative number. */
static int make_real(const struct asked *a, MPI_Datatype *type)
{
    static const struct real {
        int digits, range;
        MPI_Datatype real, complex;
    } reals[] = {{6, 37, MPI_REAL4, MPI_COMPLEX8},
                 {15, 307, MPI_REAL8, MPI_COMPLEX16},
                 {18, 4931, MPI_LONG_DOUBLE, MPI_C_LONG_DOUBLE_COMPLEX},
                 {33, 4931, MPI_REAL16, MPI_COMPLEX32}};
    int digits = a->list[0], range = a->list[1];
    if (digits == MPI_UNDEFINED && range == MPI_UNDEFINED)
        return fail(NULL, a->call, MPI_ERR_ARG, "digits and range are both MPI_UNDEFINED");
    const struct real *r = reals, *end = reals + sizeof reals / sizeof *reals;
    while (r < end && (digits > r->digits || range > r->range))
        r++;
    return make(a, r == end ? NULL : a->combiner == MPI_COMBINER_F90_REAL ? r->real : r->complex, type);
}

CALL(Type_create_f90_real, (int digits, int range, MPI_Datatype *type))
{
    return make_real(&(struct asked){CALL_Type_create_f90_real, MPI_COMBINER_F90_REAL, 2, {digits, range}},
                     type);
}

CALL(Type_create_f90_complex, (int digits, int range, MPI_Datatype *type))
{
    return make_real(
        &(struct asked){CALL_Type_create_f90_complex, MPI_COMBINER_F90_COMPLEX, 2, {digits, range}}, type);
}

CALL(Type_create_f90_integer, (int range, MPI_Datatype *type))
{
    return make(&(struct asked){CALL_Type_create_f90_integer, MPI_COMBINER_F90_INTEGER, 1, {range}},
                range <= 2    ? MPI_INTEGER1
                : range <= 4  ? MPI_INTEGER2
                : range <= 9  ? MPI_INTEGER4
                : range <= 18 ? MPI_INTEGER8
                : range <= 38 ? MPI_INTEGER16
                              : NULL,
                type);
}
