/* tally.h - times by text: how long in all, how often; and times by number, the longest first. */
#ifndef LAB_WHY_TALLY_H
#define LAB_WHY_TALLY_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "kernel/vtime.h"

struct tally_row {
    const char *label;
    vtime time;
    uint64_t count;
};

struct tally {
    void *tree; /* of tsearch; *rows, until tally_sort() */
    struct tally_row *rows;
    size_t count;
};

/* The label must last as long as the tally. */
void tally_add(struct tally *t, const char *label, vtime time);
/* Makes t->rows, the longest time first, then by label. Nothing can be added then. */
void tally_sort(struct tally *t);
void tally_free(struct tally *t);

/* The number of the longest time that was not told before; -1: none but times of 0 are left. told: which
 * were, all false at first. */
int tally_longest(const vtime_sum *times, int count, bool *told);
#endif
