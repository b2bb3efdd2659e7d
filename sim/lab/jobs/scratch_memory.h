/* scratch_memory.h - zeroed memory for tables that grow with a study. The memory is an unlinked temporary
 * file, mapped: the system can write its pages out. Without room for the file it is ordinary memory. */
#ifndef LAB_JOBS_SCRATCH_MEMORY_H
#define LAB_JOBS_SCRATCH_MEMORY_H
#include <stddef.h>

void *scratch_memory_new(size_t bytes);
void scratch_memory_free(void *p, size_t bytes);
#endif
