/* race_shadow.c - see race_shadow.h. The pages are found by hashing, with a small cache in front. */
#include "races/race_shadow.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

enum { FIRST_ROOM = 64 };

struct race_shadow *race_shadow_new(void)
{
    struct race_shadow *s = xcalloc(1, sizeof *s);
    s->room = FIRST_ROOM;
    s->pages = xcalloc(s->room, sizeof *s->pages);
    return s;
}

void race_shadow_clear(struct race_shadow *s)
{
    for (size_t i = 0; i < s->room; i++)
        free(s->pages[i].cells);
    memset(s->pages, 0, s->room * sizeof *s->pages);
    memset(s->cache, 0, sizeof s->cache);
    s->count = 0;
}

void race_shadow_free(struct race_shadow *s)
{
    if (!s)
        return;
    race_shadow_clear(s);
    free(s->pages);
    free(s);
}

/* Where a page is, or is to be put. */
static struct race_page *slot(const struct race_shadow *s, uintptr_t number)
{
    size_t i = (number * UINT64_C(0x9e3779b97f4a7c15)) >> 20 & (s->room - 1);
    while (s->pages[i].number && s->pages[i].number != number)
        i = (i + 1) & (s->room - 1);
    return &s->pages[i];
}

static void grow(struct race_shadow *s)
{
    struct race_page *old = s->pages;
    size_t room = s->room;
    s->room *= 2;
    s->pages = xcalloc(s->room, sizeof *s->pages);
    for (size_t i = 0; i < room; i++)
        if (old[i].number)
            *slot(s, old[i].number) = old[i];
    free(old);
}

static struct race_page *add(struct race_shadow *s, uintptr_t number)
{
    if (2 * s->count++ >= s->room)
        grow(s);
    struct race_page *p = slot(s, number);
    *p = (struct race_page){number, xcalloc(1, sizeof *p->cells)};
    return p;
}

static __attribute__((noinline)) struct race_cells *load(struct race_shadow *s, uintptr_t number)
{
    struct race_page *p = slot(s, number);
    if (!p->number)
        p = add(s, number);
    s->cache[number % RACE_CACHED_PAGES] = *p;
    return p->cells;
}

struct race_cells *race_shadow_page(struct race_shadow *s, uintptr_t address)
{
    uintptr_t number = address / RACE_PAGE;
    const struct race_page *cached = &s->cache[number % RACE_CACHED_PAGES];
    return cached->number == number ? cached->cells : load(s, number);
}

static void forget(struct race_cells *c, size_t first, size_t words)
{
    memset(c->known, 0, sizeof c->known);
    memset(&c->of[first], 0, words * sizeof *c->of);
}

void race_shadow_forget(struct race_shadow *s, uintptr_t address, size_t bytes)
{
    uintptr_t end = address + bytes;
    for (uintptr_t at = address - address % RACE_WORD; at < end;) {
        uintptr_t next = at - at % RACE_PAGE + RACE_PAGE;
        next = next < end ? next : end;
        const struct race_page *p = slot(s, at / RACE_PAGE);
        if (p->number)
            forget(p->cells, at % RACE_PAGE / RACE_WORD, (next - at + RACE_WORD - 1) / RACE_WORD);
        at = next;
    }
}

size_t race_shadow_bytes(const struct race_shadow *s)
{
    return sizeof *s + s->room * sizeof *s->pages + s->count * sizeof(struct race_cells);
}
