/* poll.h - the pass of nxcc --mpi: no counting, only checks. */
#ifndef NXCC_POLL_H
#define NXCC_POLL_H
#include "gcc.h"

/* In place of the counting pass, with the plugin's argument `poll`. */
opt_pass *poll_make_pass();

/* Marks the blocks of a function that are to check: those where a cycle of blocks closes, and the first if the function
 * calls others. */
void poll_mark(function *fun, bool calls, bitmap poll_blocks);
#endif
