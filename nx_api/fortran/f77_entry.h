/* f77_entry.h - what the files of this folder share: NX as Fortran programs see it, on every backend.
 *
 * GNU Fortran calls NAME as NAME_, all arguments by reference; INTEGER and LOGICAL have 4 bytes; a CHARACTER argument's
 * length follows behind the last argument, by value, so that a routine which takes any type as its buffer need not know
 * of it. A face fetches its arguments and calls the C name, which does the work, checks them, and names itself in errors.
 * All faces are weak: a program may have routines of its own by these names.
 */
#ifndef NX_FORTRAN_FACES_H
#define NX_FORTRAN_FACES_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../common/global.h"
#include "nx.h"

typedef int32_t integer;
typedef const integer in; /* an argument that is only read */

#define FACE __attribute__((weak))

/* A handler is EXTERNAL: SUBROUTINE h(type, count, node, pid [, hparam]). */
typedef void procedure(integer *, integer *, integer *, integer *, integer *);
typedef void handler4(long, long, long, long);
typedef void handler5(long, long, long, long, long);

/* C functions that call p with references to what they are given. call: whose error it is when there are too many. */
handler4 *nx_fortran_handler(procedure *p, const char *call);
handler5 *nx_fortran_xhandler(procedure *p, const char *call);

/* A CHARACTER value without the blanks behind it, as a C string to be freed. */
char *nx_fortran_text(const char *s, size_t bytes, const char *call);

/* INTEGERs as longs, to be freed. */
long *nx_fortran_longs(in *values, long count, const char *call);

/* An INTEGER(8) of irecvx: filled when its message id is complete. */
void nx_fortran_info_at(long id, integer *info, long *longs);
void nx_fortran_info_done(long id);
void nx_fortran_info_forget(long id);
void nx_fortran_info_merge(long first, long second, long merged);
void nx_fortran_info(integer *info, const long *longs);

#endif
