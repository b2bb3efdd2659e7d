/* asan_code.h - the inline assembly of nxcc --asan: it looks at the shadow of memory, or marks red zones
 * there (contract/asan.h). What is found goes the way of race_code.h to the simulator. */
#ifndef NXCC_ASAN_CODE_H
#define NXCC_ASAN_CODE_H
#include "gcc.h"

/* The most bytes that asan_code_access() looks at. */
enum { ASAN_MOST_BYTES = 56 };

/* A look at so many bytes that begin `shift` bytes behind the object; a site is an offset (race_sites.h). */
gasm *asan_code_access(tree object, int shift, unsigned bytes, size_t site);
/* Marks the red zone behind a local variable of so many bytes; marks it as usable again. */
gasm *asan_code_begin_local(tree variable, size_t bytes, size_t site);
gasm *asan_code_end_local(tree variable, size_t bytes);
#endif
