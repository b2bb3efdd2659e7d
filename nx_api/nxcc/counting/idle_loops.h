/* idle_loops.h - loops without any work, such as for (;;); Time must go by in them, or nobody could stop the
 * program. */
#ifndef NXCC_IDLE_LOOPS_H
#define NXCC_IDLE_LOOPS_H
#include "base/gcc.h"

/* Sets the bits of those blocks in poll_blocks that are on a cycle of blocks which cost nothing and have no
 * statement that needs the counter. */
void idle_loops_find(function *fun, bool (*needs_counter)(gimple *), bitmap poll_blocks, bitmap idle);
#endif
