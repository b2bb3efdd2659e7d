/* interned.h - strings of bytes, each numbered from 0 in the order in which it first came. */
#ifndef TRACE_INTERNED_H
#define TRACE_INTERNED_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct interned;

struct interned *interned_new(void);
void interned_free(struct interned *t);
/* The number of a string; *is_new: it has not come before. */
uint32_t interned_number(struct interned *t, const void *bytes, size_t length, bool *is_new);
#endif
