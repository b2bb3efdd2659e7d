/* signature.h - the type signature of what a call sends or receives: kinds of numbers, one after the other,
 * as they lie in messages. What is sent has to be received as the same kinds; a receive may have room for
 * more. MPI_BYTE is a kind of its own. */
#ifndef MPI_SIGNATURE_H
#define MPI_SIGNATURE_H
#include "mpi_api/core/told.h"

/* A list of numbers, so many times. */
struct signature {
    size_t bytes; /* of all */
    size_t repeats;
    int count; /* of list; 0: not known, or MPI_PACKED, which is received as anything */
    struct signature_run {
        uint8_t class, bytes; /* of each number; class: enum basic_class, but none is PAIR */
        size_t numbers;
    } * list;
};

/* `count` elements of a datatype, which are read where the program has it: told.h. */
struct signature signature_of(const struct nxm_library *l, int count, uintptr_t type);
void signature_free(struct signature *s);
/* Do the kinds of numbers differ, as far as both go? What they are at the first difference, as "reals of 8
 * bytes", or "integers as number 3", is malloc'd then. */
bool signatures_differ(const struct signature *a, const struct signature *b, char *kinds[2]);
#endif
