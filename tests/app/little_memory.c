/* little_memory.c - app/fail.h without NX; see little_memory.h. */
#include <stdint.h>
#include <stdlib.h>
#include "fail.h"
#include "little_memory.h"

size_t little_memory = SIZE_MAX;

void *allocate_if_room(size_t bytes)
{
    return bytes <= little_memory ? malloc(bytes) : NULL;
}

void *allocate(size_t bytes)
{
    return malloc(bytes);
}
