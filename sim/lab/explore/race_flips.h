/* race_flips.h - runs directed at races that the race checker has found: touchstone run --json of a program
 * built by nxcc --races names them. */
#ifndef LAB_EXPLORE_RACE_FLIPS_H
#define LAB_EXPLORE_RACE_FLIPS_H
#include <jansson.h>
#include "lab/explore/flips.h"

/* Adds for each race between a handler and the program, in which the handler came first, the flip that lets
 * the handler come behind the other access. races: the list of run --json; NULL: none. Of each race its
 * members first_on ("node 3") and accesses (two: in, at_s). */
void race_flips_add(struct flips *all, const struct order *o, const struct delay_bounds *bounds,
                    const json_t *races);
#endif
