/* race_shadow.h - the shadow of a node's memory: for each word of four bytes that a program built with
 * --races has accessed since a handler was first posted, its last accesses.
 *
 * A cell of a word holds six: the last read and the last write of the main program while handlers may run, of
 * the main program while they are masked, and of the handlers, each with the bytes of the word that it was
 * about. Of different bytes of one word the last access of a kind is known. So 48 bytes of shadow stand for
 * 4 bytes of memory, in pages of 1 KB of memory. Cells lie together, since one look at a cell is all that
 * most accesses need. */
#ifndef RACES_RACE_SHADOW_H
#define RACES_RACE_SHADOW_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { RACE_WORD = 4, RACE_PAGE = 1024, RACE_PAGE_WORDS = RACE_PAGE / RACE_WORD };

/* Who accesses how: reads are even, each followed by its writes. */
enum race_kind {
    RACE_MAIN_READ,
    RACE_MAIN_WRITE,
    RACE_MASKED_READ,
    RACE_MASKED_WRITE,
    RACE_HANDLER_READ,
    RACE_HANDLER_WRITE,
    RACE_KINDS
};

enum {
    RACE_PLACE_BITS = 20,
    RACE_EPOCH_BITS = 34,
    RACE_VOLATILE_BIT = RACE_EPOCH_BITS + RACE_PLACE_BITS + 4
};

struct race_access {
    uint64_t epoch : RACE_EPOCH_BITS; /* 0: there was none */
    uint64_t place : RACE_PLACE_BITS; /* races/race_places.h */
    uint64_t bytes : 4;               /* of the word, a bit each */
    uint64_t is_volatile : 1;         /* of a volatile object of at most 8 bytes */
    uint64_t excused : 1;             /* it waits for the other to write, or the source excuses it */
    uint64_t updates : 1;             /* a write to a volatile object that the same statement has read */
    uint64_t raced : 1;               /* a read of a volatile object that the other's write could follow */
    uint64_t
        flowed : 1; /* a handler's read of what the main program had written while handlers were masked */
    uint64_t restored : 1; /* a handler's, of what its run put back (races/race_restored.h); while the run
                              goes on: of what it has changed */
};
_Static_assert(sizeof(struct race_access) == 8, "an access takes a word of the computer");

struct race_cell {
    struct race_access of[RACE_KINDS];
};

/* A stretch of a page, from byte `first` up to `end`, whole words, which a strand has accessed so in one
 * epoch, as nothing volatile or excused: it need not be looked at word by word when the strand accesses it
 * again. */
struct race_stretch {
    uint64_t epoch;
    uint32_t first, end;
};

struct race_cells {
    struct race_stretch known[RACE_KINDS];
    struct race_cell of[RACE_PAGE_WORDS];
};

struct race_page {
    uintptr_t number; /* address / RACE_PAGE; 0: none, for nothing lies there */
    struct race_cells *cells;
};

enum { RACE_CACHED_PAGES = 64 };

/* For race_shadow.c and the function below. */
struct race_shadow {
    struct race_page cache[RACE_CACHED_PAGES]; /* by the last bits of the number */
    struct race_page *pages;                   /* open addressing, a power of two */
    size_t room, count;
};

/* The cell of the word at an address, if its page has been asked for lately; else NULL. */
static inline struct race_cell *race_shadow_quick(const struct race_shadow *s, uintptr_t address)
{
    uintptr_t number = address / RACE_PAGE;
    const struct race_page *cached = &s->cache[number % RACE_CACHED_PAGES];
    return cached->number == number ? &cached->cells->of[address % RACE_PAGE / RACE_WORD] : NULL;
}

struct race_shadow *race_shadow_new(void);
void race_shadow_free(struct race_shadow *s);
/* The cells of the page of an address; made if they are not there. */
struct race_cells *race_shadow_page(struct race_shadow *s, uintptr_t address);
/* Forgets the accesses to memory; all of them. */
void race_shadow_forget(struct race_shadow *s, uintptr_t address, size_t bytes);
void race_shadow_clear(struct race_shadow *s);
/* Bytes that the shadow takes. */
size_t race_shadow_bytes(const struct race_shadow *s);
#endif
