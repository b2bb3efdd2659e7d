/* race_restored.c - see race_restored.h. */
#include "races/race_restored.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "races/node_races.h"

enum { MOST_WORDS = 4096 }; /* of a run; those that come later are not restored */

void race_restored_free(struct race_restored *t)
{
    free(t->list);
    free(t->waiting);
    *t = (struct race_restored){0};
}

static uintptr_t word_of(uintptr_t at)
{
    return at - at % RACE_WORD;
}

static uint32_t bucket_of(uintptr_t word)
{
    return (uint32_t)(word / RACE_WORD % RACE_RESTORED_BUCKETS);
}

static struct race_before *find(const struct race_restored *t, uintptr_t word)
{
    for (uint32_t i = t->buckets[bucket_of(word)]; i; i = t->list[i].next)
        if (t->list[i].word == word)
            return &t->list[i];
    return NULL;
}

static struct race_cell *cell_of(const struct node_races *r, uintptr_t word)
{
    return &race_shadow_page(r->shadow, word)->of[word % RACE_PAGE / RACE_WORD];
}

/* --- during the run --- */

/* Is it in the program's data or heap? Elsewhere the program's own access may be a crash. */
static bool is_memory(const struct node *n, uintptr_t word)
{
    return word - (uintptr_t)n->guest.program < n->guest.image_bytes ||
           word - (uintptr_t)n->guest.heap_start < n->memory.heap;
}

static uint32_t value_at(uintptr_t word)
{
    uint32_t value;
    memcpy(&value, (const void *)word, sizeof value);
    return value;
}

static struct race_before *add(struct race_restored *t, uintptr_t word, const struct race_cell *c)
{
    t->count += t->count == 0;
    if (t->count == MOST_WORDS)
        return NULL;
    if (t->count >= t->room)
        t->list = xreallocarray(t->list, t->room = t->room ? 2 * t->room : 16, sizeof *t->list);
    uint32_t *first = &t->buckets[bucket_of(word)];
    t->list[t->count] =
        (struct race_before){.word = word, .value = value_at(word), .cell = *c, .next = *first};
    return &t->list[*first = t->count++];
}

struct race_before *race_restored_word(struct node_races *r, const struct node *n, const struct race_cell *c,
                                       uintptr_t at, bool small)
{
    struct race_restored *t = &r->restored;
    uint64_t run = r->handlers.run;
    bool first = c->of[RACE_HANDLER_READ].epoch != run && c->of[RACE_HANDLER_WRITE].epoch != run;
    uintptr_t word = word_of(at);
    struct race_before *b = find(t, word);
    if (!b)
        return first && small && is_memory(n, word) ? add(t, word, c) : NULL;
    b->stays |= first || !small; /* first: it was freed and allocated again */
    return b;
}

void race_restored_writes(struct node_races *r, uintptr_t at, size_t bytes)
{
    bool changed = false;
    for (uintptr_t word = word_of(at); word < at + bytes; word += RACE_WORD) {
        const struct race_before *b = find(&r->restored, word);
        changed |= b && value_at(word) != b->value;
    }
    for (uintptr_t word = word_of(at); changed && word < at + bytes; word += RACE_WORD) {
        struct race_before *b = find(&r->restored, word);
        struct race_access *last = &cell_of(r, word)->of[RACE_HANDLER_WRITE];
        if (b)
            b->changed = true;
        last->restored |= b && last->epoch == r->handlers.run;
    }
}

void race_restored_wait(struct race_restored *t, const struct race_before *word, const struct race_finding *f)
{
    if (t->waiting_count == t->waiting_room)
        t->waiting = xreallocarray(t->waiting, t->waiting_room = t->waiting_room ? 2 * t->waiting_room : 16,
                                   sizeof *t->waiting);
    t->waiting[t->waiting_count++] = (struct race_waiting){(uint32_t)(word - t->list), *f};
}

/* --- at its end --- */

/* What the run did to a word that it has restored is forgotten where an earlier run's access would be lost
 * by it; else it is kept, marked, for what it orders. */
static void restore(struct race_access *last, const struct race_access *before, uint64_t run)
{
    bool orders = last->is_volatile || last->excused;
    if (last->epoch != run)
        return;
    if (!orders && before->epoch && !before->restored)
        *last = *before;
    else
        last->restored = true;
}

static void end_word(struct node_races *r, const struct node *n, struct race_before *b)
{
    struct race_access *of = cell_of(r, b->word)->of;
    b->stays |= !b->changed || !is_memory(n, b->word) || value_at(b->word) != b->value;
    of[RACE_HANDLER_WRITE].restored &= !b->stays || of[RACE_HANDLER_WRITE].epoch != r->handlers.run;
    if (b->stays)
        return;
    for (enum race_kind k = RACE_HANDLER_READ; k <= RACE_HANDLER_WRITE; k++)
        restore(&of[k], &b->cell.of[k], r->handlers.run);
    of[RACE_MAIN_READ].raced = b->cell.of[RACE_MAIN_READ].raced;
    of[RACE_MASKED_READ].raced = b->cell.of[RACE_MASKED_READ].raced;
}

void race_restored_forget(struct race_restored *t)
{
    for (uint32_t i = 1; i < t->count; i++)
        t->buckets[bucket_of(t->list[i].word)] = 0;
    t->count = t->waiting_count = 0;
}

void race_restored_run_ends(struct node_races *r, const struct node *n)
{
    struct race_restored *t = &r->restored;
    for (uint32_t i = 1; i < t->count; i++)
        end_word(r, n, &t->list[i]);
    for (uint32_t i = 0; i < t->waiting_count; i++)
        if (t->list[t->waiting[i].word].stays)
            race_findings_add(&r->findings, &t->waiting[i].finding);
    race_restored_forget(t);
}

void race_restored_give_up(struct race_restored *t, struct race_findings *to)
{
    for (uint32_t i = 0; i < t->waiting_count; i++)
        race_findings_add(to, &t->waiting[i].finding);
    race_restored_forget(t);
}
