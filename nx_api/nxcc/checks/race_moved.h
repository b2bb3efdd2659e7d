/* race_moved.h - the source places of loads and stores that GCC's optimisers have moved: what a loop does
 * with a variable may be left to a load in front of it and to a store behind it. These are new statements,
 * which have no line.
 *
 * A pass stands before and behind those of GCC that move. It notes which memory the statements with a line
 * access, by its name in the source, and gives a new one the line of the nearest that accesses the same:
 * after it if it loads, before it if it stores, and in the loop next to it if there is one. It sets nothing
 * but the line, not the function, for a statement's cost depends on that. */
#ifndef NXCC_RACE_MOVED_H
#define NXCC_RACE_MOVED_H
#include "base/gcc.h"

/* Registers the pass at all its places. */
void race_moved_register(const char *plugin);
#endif
