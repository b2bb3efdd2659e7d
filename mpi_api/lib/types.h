/* types.h - what the files that make datatypes, and answer about them, share. */
#ifndef MPI_TYPES_H
#define MPI_TYPES_H
#include "lib.h"

/* A new datatype with nothing in it. */
struct type *type_new(void);
/* Adds `count` elements of old, one extent after the other, from `at` on. *room: what its list of runs has
 * room for, 0 at first. */
void type_add(struct type *t, int *room, const struct type *old, int count, MPI_Aint at);
/* What it was made of, so many of each, which are to be filled in: Type_get_contents. */
void type_made_of(struct type *t, int ints, int addresses, int types);
void type_made_of_type(struct type *t, int i, MPI_Datatype old);
/* All blocks are there. padded: a struct's end is aligned as a C compiler does. */
MPI_Datatype type_finish(struct type *t, int combiner, bool padded);
#endif
