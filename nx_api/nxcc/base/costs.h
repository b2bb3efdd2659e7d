/* costs.h - the cost of one GIMPLE statement on the simulated processor, in cost units (image.h).
 *
 * The statements are those that GCC's optimisers leave just before they become machine code. An SSA copy, a
 * PHI, a conversion between integers, and an address that folds into a memory reference are no operations and
 * cost nothing. A statement's cost is multiplied by the cost factor of the function in whose source it is
 * written, also where that function is inlined into another.
 */
#ifndef NXCC_COSTS_H
#define NXCC_COSTS_H
#include "base/table.h"

/* The cost table and the factors to use. To be called once, before the others. */
void costs_use(const cost_table &table, const std::vector<cost_factor> &factors);

/* The units of one execution of stmt; for a call without its argument-dependent cost (costs_of_call). */
int64_t costs_of(gimple *stmt);

/* The units of the jump back in a loop in which nothing else costs anything. stmt: one of its statements. */
int64_t costs_of_going_back(gimple *stmt);

/* The function in whose source stmt is written. */
tree costs_written_in(gimple *stmt);

/* The name of the library function that stmt calls, if the cost table has a cost for it, or NULL. */
const char *costs_priced_call(gimple *stmt);

/* Is an operand in memory? */
bool costs_is_memory(tree operand);

/* The argument-dependent cost of a call: units for each unit of what *price counts (table.h); 0 if there is
 * none. Ends the compilation if the library's function has no such argument. */
int64_t costs_of_call(gcall *call, const call_cost **price);

/* Ends the compilation if a price reads an argument that one of GCC's built-in functions does not have. */
void costs_check_built_in();

/* Is it a call that neither reads nor changes the counter, and does not come back to counted code? GCC
 * expands such a call in place, or it is of a pure function of the C library. */
bool costs_call_is_uncounted(gcall *call);

/* Warns if a function that is defined here would be taken for the C library's by other files of the
 * program. */
void costs_warn_if_taken_for_library(tree function);
#endif
