/* libgfortran.h - what of GNU Fortran's run-time library (GCC 8 to 14) the files of this folder call or
 * replace.
 *
 * A Fortran node program holds that library, taken from the compiler's libgfortran.a, so that each node
 * has its own units. Parts of it are not for a node: its errors and STOP, which are to name node and time;
 * its threads, whose thread-local variables an image cannot have; its choice of instructions by the host's
 * processor. As the linker takes from an archive only what is not defined yet, these files define all
 * names of such a part, and the part stays out. They are the program's own code, but not counted. */
#ifndef NX_LIBGFORTRAN_H
#define NX_LIBGFORTRAN_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The start of what the compiler hands over with each I/O statement; the layout is part of the compiler's
 * contract. */
struct statement {
    int32_t flags; /* STATEMENT_*; the two lowest bits are the result */
    int32_t unit;
    const char *file; /* of the source */
    int32_t line;
    size_t message_bytes;
    char *message;   /* IOMSG= */
    int32_t *status; /* IOSTAT= */
};

enum {
    RESULT_ERROR = 1,
    RESULT_END = 2,
    RESULT_EOR = 3,
    RESULT_MASK = 3,
    HAS_ERR = 1 << 2, /* labels: the program goes on there */
    HAS_END = 1 << 3,
    HAS_EOR = 1 << 4,
    HAS_STATUS = 1 << 5,
    HAS_MESSAGE = 1 << 6,
    TEXT_FORMATS = 1 << 7 | 1 << 12 | 1 << 15, /* *, a FORMAT, NML= */
};

/* How the compiler hands over an array. */
struct descriptor {
    void *first;
    int64_t offset;
    uint64_t element_bytes;
    int32_t version;
    signed char rank, type; /* TYPE_* */
    int16_t attribute;
    int64_t span;
    struct {
        int64_t stride, lower, upper;
    } dimension[];
};

enum { TYPE_INTEGER = 1, TYPE_LOGICAL, TYPE_REAL, TYPE_COMPLEX, TYPE_DERIVED, TYPE_CHARACTER };

/* Its elements: elements.c. */
long nx_elements(const struct descriptor *d);

enum { ERROR_EOR = -2, ERROR_END = -1, ERROR_OS = 5000 };

/* The library's. */
void _gfortrani_close_units(void);
void _gfortrani_stupid_function_name_for_static_linking(void); /* does nothing */
char *_gfortrani_filename_from_unit(int unit);                 /* to be freed; NULL */

/* The simulator's: ends the program; the message names node and time, says text, and where the program
 * was, if frame is that of the function of the library that it called. */
_Noreturn void nx_die(const char *text, const void *frame);

#endif
