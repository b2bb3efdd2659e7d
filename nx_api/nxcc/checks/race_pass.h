/* race_pass.h - the pass of nxcc --races: puts before each load and store of memory that others can reach a
 * report of it to the simulator (contract/races.h).
 *
 * The pass runs behind the counting pass, so that it changes no cost: a report takes no virtual time.
 * GCC's optimisers have run before. Accesses that they have merged are reported once, and those that they
 * have moved where they are now: a variable that is not volatile may be read once before a loop although the
 * source reads it in the loop. (Only where the cost table has a simulated cache do times change a little: the
 * program is larger, so that its variables have other addresses.)
 *
 * No report is made of: variables of the function whose address nobody else has; constants; in a block, and
 * in those that follow it alone, what was reported since the last call or poll; what inline assembly of the
 * program touches, and NX's calls: what these and other library calls have pointers to is listed
 * (NXC_RACE_GIVEN). */
#ifndef NXCC_RACE_PASS_H
#define NXCC_RACE_PASS_H
#include "base/gcc.h"

/* The pass that follows the counting pass. */
opt_pass *race_pass_make();
/* The pass of nxcc --asan, in its place: before each load and store that may go outside of what it is written
 * for, there is a look at the shadow of the memory (contract/asan.h); what library functions do is reported
 * as for --races. Left out are accesses of a variable that lie within it wherever the program goes. */
opt_pass *race_pass_make_asan();
#endif
