/* library_call.h - the function of a shared library that a program's call is of. */
#ifndef MPI_LIBRARY_CALL_H
#define MPI_LIBRARY_CALL_H
#include <stdint.h>

/* "strlen", for the address in the program behind the call; NULL: not known. May be called in a handler of a
 * signal. */
const char *library_call_name(uintptr_t behind);
#endif
