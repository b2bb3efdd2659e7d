/* scratch_memory.h - zeroed memory for tables that grow with a study: it lies in a file without a name, so that the system can take
 * the pages back, and those never touched take no room anywhere. */
#ifndef LAB_JOBS_SCRATCH_MEMORY_H
#define LAB_JOBS_SCRATCH_MEMORY_H
#include <stddef.h>

void *scratch_memory_new(size_t bytes);
void scratch_memory_free(void *p, size_t bytes);
#endif
