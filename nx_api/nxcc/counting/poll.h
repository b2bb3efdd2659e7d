/* poll.h - the pass of nxcc --mpi, which adds polls and counts nothing; and the blocks in which either pass
 * polls. */
#ifndef NXCC_POLL_H
#define NXCC_POLL_H
#include "base/gcc.h"

/* The pass that stands in place of the counting pass when the plugin has the argument `poll`. */
opt_pass *poll_make_pass();

/* Sets the bits of the blocks of a function that are to poll: each block that a cycle of blocks goes back to,
 * and the first block if the function calls others. */
void poll_mark(function *fun, bool calls, bitmap poll_blocks);
#endif
