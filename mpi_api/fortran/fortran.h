/* fortran.h - what the Fortran bindings share. Fortran hands everything by reference: handles are INTEGERs,
 * the same numbers as C's; a status is an array of as many INTEGERs as C's has ints; texts are followed by
 * blanks, and their lengths come last. */
#ifndef MPI_FORTRAN_H
#define MPI_FORTRAN_H
#include <stdlib.h>
#include <string.h>
#include "mpi_api/lib/coll.h"

typedef MPI_Fint f_int;

/* A subroutine, which programs reach by both of its names. */
#define FORTRAN(name, parameters)                                                                            \
    void mpi_##name##_ parameters __attribute__((weak, alias("pmpi_" #name "_")));                           \
    void pmpi_##name##_ parameters;                                                                          \
    void pmpi_##name##_ parameters

/* Where a subroutine puts its error code: its last argument, which programs with mpi_f08 may leave out. */
extern f_int f_no_ierr;
#define IERR (*(ierr ? ierr : &f_no_ierr))

/* Variables of COMMON blocks of mpif.h, whose addresses mean something. MPI_BOTTOM is as good a place as 0:
 * Fortran's addresses are counted from there, so that they fit into an INTEGER. */
extern f_int mpi_fortran_in_place_, mpi_fortran_bottom_, mpi_fortran_unweighted_, mpi_fortran_weights_empty_;
extern f_int mpi_fortran_status_ignore_[8], mpi_fortran_statuses_ignore_[8];

static inline void *f_buffer(void *p)
{
    return p == &mpi_fortran_in_place_ ? MPI_IN_PLACE : p;
}

static inline MPI_Status *f_status(f_int *s)
{
    return s == mpi_fortran_status_ignore_ || s == mpi_fortran_statuses_ignore_ ? MPI_STATUS_IGNORE
                                                                                : (MPI_Status *)s;
}

#define F_HANDLE(type, x) ((type)(intptr_t)(x))

#define F_COMM(x) F_HANDLE(MPI_Comm, *(x))
#define F_TYPE(x) F_HANDLE(MPI_Datatype, *(x))
#define F_GROUP(x) F_HANDLE(MPI_Group, *(x))
#define F_OF(handle) ((f_int)(intptr_t)(handle))

/* A call with a handle that it changes: declares `handle`, and gives it back. */
#define WITH(type, x, call)                                                                                  \
    do {                                                                                                     \
        type handle = F_HANDLE(type, *(x));                                                                  \
        IERR = (call);                                                                                       \
        *(x) = F_OF(handle);                                                                                 \
    } while (0)

/* A call that makes a handle, `made`, which x gets. */
#define NEW(type, x, call)                                                                                   \
    do {                                                                                                     \
        type made;                                                                                           \
        IERR = (call);                                                                                       \
        if (!IERR)                                                                                           \
            *(x) = F_OF(made);                                                                               \
    } while (0)

/* A list of datatypes, to be freed. (A negative count is for the call to refuse.) */
static inline MPI_Datatype *f_types(const f_int *list, int count)
{
    MPI_Datatype *types = get_memory(count > 0 ? (size_t)count * sizeof *types : 0);
    for (int i = 0; i < count; i++)
        types[i] = F_TYPE(&list[i]);
    return types;
}

/* The datatypes of two lists, one behind the other: what is sent, and what is received. */
static inline MPI_Datatype *f_both_types(const f_int *out, int outs, const f_int *in, int ins)
{
    MPI_Datatype *types = get_memory(((size_t)outs + (size_t)ins) * sizeof *types);
    for (int i = 0; i < outs + ins; i++)
        types[i] = F_TYPE(i < outs ? &out[i] : &in[i - outs]);
    return types;
}

/* A call with such a list, which makes a request: the list lasts as long as that. */
#define NEW_WITH_LIST(x, list, call)                                                                         \
    do {                                                                                                     \
        NEW(MPI_Request, x, call);                                                                           \
        if (IERR)                                                                                            \
            free(list);                                                                                      \
        else                                                                                                 \
            coll_keep_list(F_HANDLE(MPI_Request, *(x)), list);                                               \
    } while (0)

/* A text without the blanks behind it, to be freed; a text with blanks behind it. */
static inline char *f_text(const char *s, size_t length)
{
    while (length && s[length - 1] == ' ')
        length--;
    return strndup(s, length);
}

static inline void f_give_text(char *to, size_t room, const char *text)
{
    size_t length = strnlen(text, room);
    memcpy(to, text, length);
    memset(to + length, ' ', room - length);
}

/* The calls that name a communicator, a datatype or a window, and answer its name. */
#define NAMES(lower, Upper, F_HANDLE_OF)                                                                     \
    FORTRAN(lower##_set_name, (f_int * handle, const char *name, f_int *ierr, size_t length))                \
    {                                                                                                        \
        char *text = f_text(name, length);                                                                   \
        IERR = MPI_##Upper##_set_name(F_HANDLE_OF(handle), text);                                            \
        free(text);                                                                                          \
    }                                                                                                        \
    FORTRAN(lower##_get_name, (f_int * handle, char *name, f_int *length, f_int *ierr, size_t room))         \
    {                                                                                                        \
        char text[MPI_MAX_OBJECT_NAME];                                                                      \
        IERR = MPI_##Upper##_get_name(F_HANDLE_OF(handle), text, length);                                    \
        if (!IERR)                                                                                           \
            f_give_text(name, room, text);                                                                   \
    }
#endif
