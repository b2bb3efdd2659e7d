/* race_reach.h - memory that others than the function being compiled can reach. */
#ifndef NXCC_RACE_REACH_H
#define NXCC_RACE_REACH_H
#include "base/gcc.h"

/* May others reach what an operand of a statement is? Not if it is no memory. */
bool race_reach(tree operand);
/* May others reach what a pointer points to? */
bool race_reach_behind(tree pointer);
/* Is the base of a reference a variable of the counting pass, or a word of the profile, whose address inline
 * assembly gives? */
bool race_reach_is_own(tree base);
#endif
