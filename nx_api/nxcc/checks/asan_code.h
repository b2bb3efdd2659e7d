/* asan_code.h - the inline assembly of nxcc --asan: it looks at the shadow of memory, or marks red zones
 * there (contract/asan.h). What is found goes the way of race_code.h to the simulator. */
#ifndef NXCC_ASAN_CODE_H
#define NXCC_ASAN_CODE_H
#include "base/gcc.h"

/* The most bytes that asan_code_access() looks at. */
enum { ASAN_MOST_BYTES = 56 };

/* A look at so many bytes that begin `shift` bytes behind the object; a site is an offset (race_sites.h). */
gasm *asan_code_access(tree object, int shift, unsigned bytes, size_t site);
/* The beginning of a local variable of so many bytes: marks the red zone behind it, and that the variable may
 * be used, whoever had its place before. The end, at its function's return: variable and zone may not. */
gasm *asan_code_begin_local(tree variable, size_t bytes, size_t site);
gasm *asan_code_end_local(tree variable, size_t bytes);
/* Code that marks the zone of a block that alloca has given with room for it: address and bytes are values.
 * Code for the end of all blocks below an address of the frame; NULL_TREE: of all that the function has. */
gasm *asan_code_begin_block(tree address, tree bytes, size_t site);
gasm *asan_code_end_blocks(tree end);
#endif
