/* f77_entry.h - NX as Fortran programs see it, on every back end: what the files of this folder share.
 *
 * GNU Fortran calls NAME as NAME_, with all arguments by reference. INTEGER and LOGICAL have 4 bytes. A
 * CHARACTER argument's length follows the last argument, by value, so that a routine whose buffer may have
 * any type can ignore lengths. An entry point fetches its arguments and calls the C name, which checks them,
 * does the work, and names itself in errors. All entry points are weak: a program may have routines of its
 * own by these names.
 */
#ifndef F77_ENTRY_H
#define F77_ENTRY_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../common/global.h"
#include "nx.h"

typedef int32_t integer;
typedef const integer in; /* an argument that is only read */

#define ENTRY __attribute__((weak))

/* A handler is EXTERNAL: SUBROUTINE h(type, count, node, pid [, hparam]). */
typedef void procedure(integer *, integer *, integer *, integer *, integer *);
typedef void handler4(long, long, long, long);
typedef void handler5(long, long, long, long, long);

/* C functions that call p with references to their arguments. call: is named in the error of too many
 * procedures. */
handler4 *nx_fortran_handler(procedure *p, const char *call);
handler5 *nx_fortran_xhandler(procedure *p, const char *call);

/* A CHARACTER value without trailing blanks, as a C string to be freed. */
char *nx_fortran_text(const char *s, size_t bytes, const char *call);

/* INTEGERs as longs, to be freed. */
long *nx_fortran_longs(in *values, long count, const char *call);

/* INFO(8) of irecvx, which is filled when its message id is complete. */
void nx_fortran_info_at(long id, integer *info, long *longs);
void nx_fortran_info_done(long id);
/* The id is about to be cancelled, or ignored: then NX may still write to the longs. */
void nx_fortran_info_forget(long id, bool ignored);
void nx_fortran_info_merge(long first, long second, long merged);
void nx_fortran_info(integer *info, const long *longs);

#endif
