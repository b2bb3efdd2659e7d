/* little_memory.h - for tests: memory for the model program's files, as little as a test likes. */
#ifndef LITTLE_MEMORY_H
#define LITTLE_MEMORY_H
#include <stddef.h>

/* Allocations of more bytes fail; at first none does. */
extern size_t little_memory;
#endif
