/* asan_shadow.h - the shadow of nodes' memory: which bytes a program may access (contract/asan.h). Knows
 * nothing of nodes. */
#ifndef ASAN_ASAN_SHADOW_H
#define ASAN_ASAN_SHADOW_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A stretch of addresses with their shadow. */
struct asan_shadow {
    uintptr_t low;
    size_t bytes;
    uint8_t *of;
};

/* A file of shadow for memory that is others', which all shadows map; to be closed. -1: none can be made. */
int asan_shadow_others(void);
/* Makes a shadow, by which all memory is others'. False: this computer has no address space left. */
bool asan_shadow_begin(struct asan_shadow *s, uintptr_t low, size_t bytes, int others);
/* These bytes are the program's own: they may be accessed, and marked from now on, which takes memory. So may
 * neighbours, up to 32 KB on each side, since the shadow is made by pages. */
bool asan_shadow_own(const struct asan_shadow *s, uintptr_t at, size_t bytes);
void asan_shadow_end(struct asan_shadow *s);

/* Nobody may access these bytes, for a reason of enum nxc_asan_shadow. Of a last grain only the first bytes
 * cannot be marked: they stay as they are. */
void asan_shadow_mark(const struct asan_shadow *s, uintptr_t at, size_t bytes, uint8_t why);
/* These bytes may be accessed, from a whole grain on; of their last grain, no more than these. */
void asan_shadow_open(const struct asan_shadow *s, uintptr_t at, size_t bytes);
/* The bytes from here on may be accessed that may not for the same reason. */
void asan_shadow_open_alike(const struct asan_shadow *s, uintptr_t at);
/* These bytes, and all of their last grain, are as at first; memory of the host is given back. */
void asan_shadow_forget(const struct asan_shadow *s, uintptr_t at, size_t bytes);
/* The first of these bytes that may not be accessed; 0: there is none. Bytes outside may be accessed. */
uintptr_t asan_shadow_first(const struct asan_shadow *s, uintptr_t at, size_t bytes);
/* Why a byte may not be accessed; of one outside: it is others'. */
uint8_t asan_shadow_why(const struct asan_shadow *s, uintptr_t at);
#endif
