/* race_restored.h - what a run of a handler puts back as it found it: a depth counted up and down again, a
 * flag "in the handler". A handler runs to its end before the main program goes on. So the main program never
 * meets another value of such a word than without the handler, and what the run did to the word is no race.
 *
 * A word is restored if the run was seen to change it, by accesses of a few bytes, and its value at the end
 * of the run is that at the beginning. (A write of the value that is there anyway restores nothing: at
 * another time another value would have been there.) That is known at the end of the run; until then, races
 * of the words wait here. A run that does not restore the word has its races told. */
#ifndef RACES_RACE_RESTORED_H
#define RACES_RACE_RESTORED_H
#include "node/node.h"
#include "races/race_findings.h"
#include "races/race_shadow.h"

struct node_races;

enum { RACE_RESTORED_BUCKETS = 256, RACE_RESTORED_BYTES = 16 };

/* A word that the present run has accessed, as it was before. */
struct race_before {
    uintptr_t word; /* its address */
    uint32_t value;
    bool changed;
    bool stays; /* it is not restored */
    struct race_cell cell;
    uint32_t next;
};

struct race_waiting {
    uint32_t word; /* its number in the list */
    struct race_finding finding;
};

struct race_restored {
    struct race_before *list; /* list[0] is not used */
    struct race_waiting *waiting;
    uint32_t count, room, waiting_count, waiting_room;
    uint32_t buckets[RACE_RESTORED_BUCKETS];
};

void race_restored_free(struct race_restored *t);
/* A handler is about to access the word with that cell: of at most RACE_RESTORED_BYTES (small), or otherwise.
 * Returns the word, on which races have to wait; NULL: they have not. */
struct race_before *race_restored_word(struct node_races *r, const struct node *n, const struct race_cell *c,
                                       uintptr_t at, bool small);
/* The handler is about to write a few bytes: has it changed them before? */
void race_restored_writes(struct node_races *r, uintptr_t at, size_t bytes);
/* A race of the word is found. */
void race_restored_wait(struct race_restored *t, const struct race_before *word,
                        const struct race_finding *f);
/* The run is over. */
void race_restored_run_ends(struct node_races *r, const struct node *n);
/* The run will not end: its races are told, or forgotten. */
void race_restored_give_up(struct race_restored *t, struct race_findings *to);
void race_restored_forget(struct race_restored *t);
#endif
