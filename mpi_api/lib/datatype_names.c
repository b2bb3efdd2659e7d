/* datatype_names.c - the names of datatypes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "types.h"

CALL(Type_set_name, (MPI_Datatype type, const char *name))
{
    struct type *t = type_of(type);
    if (!t)
        return type_missing(CALL_Type_set_name);
    free(t->name);
    t->name = strndup(name, MPI_MAX_OBJECT_NAME - 1);
    return MPI_SUCCESS;
}

/* A type of MPI's own by the name of its constant. */
static const char *own_name(MPI_Datatype type)
{
#define NAME(t)                                                                                              \
    {                                                                                                        \
        t, #t                                                                                                \
    }
    static const struct name {
        MPI_Datatype type;
        const char *name;
    } names[] = {NAME(MPI_INT),
                 NAME(MPI_DOUBLE),
                 NAME(MPI_FLOAT),
                 NAME(MPI_CHAR),
                 NAME(MPI_BYTE),
                 NAME(MPI_PACKED),
                 NAME(MPI_SHORT),
                 NAME(MPI_LONG),
                 NAME(MPI_LONG_LONG_INT),
                 NAME(MPI_UNSIGNED_SHORT),
                 NAME(MPI_UNSIGNED),
                 NAME(MPI_UNSIGNED_LONG),
                 NAME(MPI_UNSIGNED_LONG_LONG),
                 NAME(MPI_SIGNED_CHAR),
                 NAME(MPI_UNSIGNED_CHAR),
                 NAME(MPI_LONG_DOUBLE),
                 NAME(MPI_WCHAR),
                 NAME(MPI_FLOAT_INT),
                 NAME(MPI_DOUBLE_INT),
                 NAME(MPI_LONG_INT),
                 NAME(MPI_2INT),
                 NAME(MPI_SHORT_INT),
                 NAME(MPI_LONG_DOUBLE_INT),
                 NAME(MPI_LOGICAL),
                 NAME(MPI_INTEGER),
                 NAME(MPI_REAL),
                 NAME(MPI_COMPLEX),
                 NAME(MPI_DOUBLE_PRECISION),
                 NAME(MPI_DOUBLE_COMPLEX),
                 NAME(MPI_CHARACTER),
                 NAME(MPI_2REAL),
                 NAME(MPI_2DOUBLE_PRECISION),
                 NAME(MPI_2INTEGER),
                 NAME(MPI_INT8_T),
                 NAME(MPI_INT16_T),
                 NAME(MPI_INT32_T),
                 NAME(MPI_INT64_T),
                 NAME(MPI_UINT8_T),
                 NAME(MPI_UINT16_T),
                 NAME(MPI_UINT32_T),
                 NAME(MPI_UINT64_T),
                 NAME(MPI_C_BOOL),
                 NAME(MPI_C_COMPLEX),
                 NAME(MPI_C_DOUBLE_COMPLEX),
                 NAME(MPI_C_LONG_DOUBLE_COMPLEX),
                 NAME(MPI_AINT),
                 NAME(MPI_COUNT),
                 NAME(MPI_OFFSET),
                 NAME(MPI_INTEGER1),
                 NAME(MPI_INTEGER2),
                 NAME(MPI_INTEGER4),
                 NAME(MPI_INTEGER8),
                 NAME(MPI_REAL4),
                 NAME(MPI_REAL8),
                 NAME(MPI_COMPLEX8),
                 NAME(MPI_COMPLEX16),
                 NAME(MPI_REAL16),
                 NAME(MPI_INTEGER16),
                 NAME(MPI_COMPLEX32),
                 NAME(MPI_CXX_BOOL),
                 NAME(MPI_CXX_FLOAT_COMPLEX),
                 NAME(MPI_CXX_DOUBLE_COMPLEX),
                 NAME(MPI_CXX_LONG_DOUBLE_COMPLEX),
                 NAME(MPI_LOGICAL4),
                 NAME(MPI_LOGICAL8),
                 NAME(MPI_LB),
                 NAME(MPI_UB)};
#undef NAME
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (names[i].type == type)
            return names[i].name;
    return "";
}

CALL(Type_get_name, (MPI_Datatype type, char *name, int *length))
{
    const struct type *t = type_of(type);
    if (!t && type != MPI_DATATYPE_NULL)
        return type_missing(CALL_Type_get_name);
    *length = snprintf(name, MPI_MAX_OBJECT_NAME, "%s",
                       !t        ? "MPI_DATATYPE_NULL"
                       : t->name ? t->name
                                 : own_name(type));
    return MPI_SUCCESS;
}
