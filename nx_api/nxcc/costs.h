/* costs.h - what one GIMPLE statement costs on the simulated processor.
 *
 * The statements are those left by GCC's optimisers just before they become machine code, so an SSA copy, a
 * PHI, a cast between integers or an address folded into a memory reference is not an operation and costs
 * nothing. A statement's cost is multiplied by the cost factor of the function it was written in, also when
 * that function was inlined into another.
 */
#ifndef NXCC_COSTS_H
#define NXCC_COSTS_H
#include "table.h"

/* The files to use; must be called once before the others. */
void costs_use(const cost_table &table, const std::vector<cost_factor> &factors);

/* Units of one execution of stmt. For a call this is the fixed part: see costs_of_call. */
int64_t costs_of(gimple *stmt);

/* Units of going back in a loop in which nothing else costs anything; stmt stands where it is. */
int64_t costs_of_going_back(gimple *stmt);

/* The function that stmt was written in. */
tree costs_written_in(gimple *stmt);

/* The name of the library function that stmt calls, if the cost table prices it, or NULL. */
const char *costs_priced_call(gimple *stmt);

/* Is it an operand that lies in memory? */
bool costs_is_memory(tree operand);

/* The part of a call's cost that depends on its arguments or result: units each, 0 if none; *of tells of
 * what, *elements whether that is an array with so many elements. */
int64_t costs_of_call(gcall *call, const std::vector<int> **of, bool *elements);

/* True if the call cannot look at or change the counter, nor come back to counted code: it is expanded in
 * place, or it is one of the C library's pure functions. */
bool costs_call_is_uncounted(gcall *call);

/* Warns if function, defined here, would be taken for the C library's by the other files of the program. */
void costs_warn_if_taken_for_library(tree function);
#endif
