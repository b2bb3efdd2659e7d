/* race_names.h - what a reference or a pointer concerns, in the source's words: "queue[i].next", "p->count",
 * in Fortran "a(...)". An index is told if it is a constant or a variable, otherwise as "...". */
#ifndef NXCC_RACE_NAMES_H
#define NXCC_RACE_NAMES_H
#include "base/gcc.h"
#include <string>

/* The name of a reference to memory, as far as the reference itself tells; "": it has none. */
std::string race_name_of(tree ref);
/* The name of what a pointer points to. */
std::string race_name_behind(tree pointer);
/* The name of a Fortran array whose descriptor a statement is given by a pointer. */
std::string race_name_of_array(gimple *stmt, tree pointer);
#endif
