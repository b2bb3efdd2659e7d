/* race_code.h - the inline assembly that tells the simulator of an access: a comparison with memory, and a
 * branch that is not taken while the simulator does not want accesses. The branch leads out of line to a
 * routine that saves every register (race_runtime.c).
 *
 * A site is given by its offset in the file's table (race_sites.h). */
#ifndef NXCC_RACE_CODE_H
#define NXCC_RACE_CODE_H
#include "base/gcc.h"

/* A telling of the bytes that begin `shift` bytes behind the object. */
gasm *race_code_access(tree object, int shift, size_t site);
/* A telling of so many bytes, a size_t, from an address; both are constants or in registers. bytes may be
 * marked as those of a string (race_runtime.h). */
gasm *race_code_range(tree address, tree bytes, size_t site);
#endif
