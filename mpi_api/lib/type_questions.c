/* type_questions.c - what a datatype is: its size, its bounds, what it was made of; and addresses. */
#include <limits.h>
#include <string.h>
#include "types.h"

#define GET(name, type_of_value, expression)                                                                 \
    CALL(name, (MPI_Datatype type, type_of_value * value))                                                   \
    {                                                                                                        \
        const struct type *t = type_of(type);                                                                \
        if (!t)                                                                                              \
            return type_missing(CALL_##name);                                                                \
        if (!value)                                                                                          \
            return fail_answer(NULL, CALL_##name);                                                           \
        *value = (type_of_value)(expression);                                                                \
        return MPI_SUCCESS;                                                                                  \
    }
GET(Type_size, int, t->size > INT_MAX ? (size_t)MPI_UNDEFINED : t->size)
GET(Type_size_x, MPI_Count, t->size)
GET(Type_extent, MPI_Aint, type_extent(t))
GET(Type_lb, MPI_Aint, t->lb)
GET(Type_ub, MPI_Aint, t->ub)

#define GET_EXTENT(name, type_of_value, lower, upper)                                                        \
    CALL(name, (MPI_Datatype type, type_of_value * lb, type_of_value * extent))                              \
    {                                                                                                        \
        const struct type *t = type_of(type);                                                                \
        if (!t)                                                                                              \
            return type_missing(CALL_##name);                                                                \
        if (!lb || !extent)                                                                                  \
            return fail_answer(NULL, CALL_##name);                                                           \
        *lb = t->lower, *extent = t->upper - t->lower;                                                       \
        return MPI_SUCCESS;                                                                                  \
    }
GET_EXTENT(Type_get_extent, MPI_Aint, lb, ub)
GET_EXTENT(Type_get_extent_x, MPI_Count, lb, ub)
GET_EXTENT(Type_get_true_extent, MPI_Aint, true_lb, true_ub)
GET_EXTENT(Type_get_true_extent_x, MPI_Count, true_lb, true_ub)

CALL(Type_match_size, (int kind, int size, MPI_Datatype *type))
{
    static const struct match {
        int kind, size;
        MPI_Datatype type;
    } matches[] = {{MPI_TYPECLASS_INTEGER, 1, MPI_INTEGER1},   {MPI_TYPECLASS_INTEGER, 2, MPI_INTEGER2},
                   {MPI_TYPECLASS_INTEGER, 4, MPI_INTEGER4},   {MPI_TYPECLASS_INTEGER, 8, MPI_INTEGER8},
                   {MPI_TYPECLASS_REAL, 4, MPI_REAL4},         {MPI_TYPECLASS_REAL, 8, MPI_REAL8},
                   {MPI_TYPECLASS_REAL, 16, MPI_REAL16},       {MPI_TYPECLASS_COMPLEX, 8, MPI_COMPLEX8},
                   {MPI_TYPECLASS_COMPLEX, 16, MPI_COMPLEX16}, {MPI_TYPECLASS_COMPLEX, 32, MPI_COMPLEX32}};
    for (size_t i = 0; i < sizeof matches / sizeof *matches; i++)
        if (matches[i].kind == kind && matches[i].size == size)
            return *type = matches[i].type, MPI_SUCCESS;
    return fail(NULL, CALL_Type_match_size, MPI_ERR_ARG, "no datatype of this kind has %d bytes", size);
}

CALL(Type_get_envelope, (MPI_Datatype type, int *ints, int *addresses, int *types, int *combiner))
{
    const struct type *t = type_of(type);
    if (!t)
        return type_missing(CALL_Type_get_envelope);
    *ints = t->ints, *addresses = t->addresses, *types = t->types, *combiner = t->combiner;
    return MPI_SUCCESS;
}

CALL(Type_get_contents, (MPI_Datatype type, int max_ints, int max_addresses, int max_types, int ints[],
                         MPI_Aint addresses[], MPI_Datatype types[]))
{
    const struct type *t = type_of(type);
    if (!t)
        return type_missing(CALL_Type_get_contents);
    if (t->combiner == MPI_COMBINER_NAMED || max_ints < t->ints || max_addresses < t->addresses ||
        max_types < t->types)
        return fail(NULL, CALL_Type_get_contents, MPI_ERR_ARG, "a type of MPI's own, or too little room");
    memcpy(ints, t->int_list, (size_t)t->ints * sizeof *ints);
    memcpy(addresses, t->address_list, (size_t)t->addresses * sizeof *addresses);
    for (int i = 0; i < t->types; i++) {
        types[i] = t->type_list[i];
        type_keep(types[i]);
    }
    return MPI_SUCCESS;
}

CALL(Get_address, (const void *at, MPI_Aint *address))
{
    *address = (MPI_Aint)at;
    return MPI_SUCCESS;
}
