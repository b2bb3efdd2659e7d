/* rewrite.h - statements of compilers of the time that GNU Fortran refuses, as statements that it takes. */
#ifndef DRIVER_REWRITE_H
#define DRIVER_REWRITE_H
#include <stdbool.h>
#include <stddef.h>
#include "nx_api/driver/source.h"

/* When an INTEGER is true as a condition. */
enum truth { ODD, NOT_ZERO };

/* The new text of a statement of which the compiler complains behind its first `at` characters, for
 * free(), with newlines between statements. NULL: the rule does not apply. */
typedef char *rewriting(const struct statement *st, size_t at, enum truth truth);

/* The rule for a line of the compiler's messages, or NULL. */
rewriting *rewriting_for(const char *message);

#endif
