/* delays.h - in what a run differs from the machine's usual timing, as lists and as schedule files
 * (doc/schedule-format.md). */
#ifndef LAB_EXPLORE_DELAYS_H
#define LAB_EXPLORE_DELAYS_H
#include <stddef.h>
#include <stdint.h>

enum delay_kind { DELAY_SPEED, DELAY_START, DELAY_MESSAGE, DELAY_INTERRUPT, DELAY_KINDS };

/* How much slower a node computes (parts per million), or how much later it starts, a message leaves or a
 * handler becomes due (picoseconds). */
struct delay {
    enum delay_kind kind;
    uint32_t node;
    uint64_t index; /* of the message or handler at that node; 0 of the other kinds */
    int64_t value;
};

struct delays {
    struct delay *list; /* malloc'd */
    size_t count;
};

void delays_free(struct delays *d);
struct delays delays_copy(const struct delays *d);
/* Those of the list for which keep[] is true. */
struct delays delays_subset(const struct delays *d, const unsigned char *keep);

/* Adds one at the end, which the list must not have yet. */
void delays_append(struct delays *d, struct delay one);
/* Adds `more` to the delay of that kind, node and index. */
void delays_add(struct delays *d, enum delay_kind kind, uint32_t node, uint64_t index, int64_t more);
/* The delay of that kind, node and index; 0: there is none. */
int64_t delays_value(const struct delays *d, enum delay_kind kind, uint32_t node, uint64_t index);

/* A schedule file of delays alone, malloc'd. comment: lines that each begin with '#', or "". */
char *delays_text(const struct delays *d, uint32_t nodes, const char *comment);
/* "the 18th message that node 3 sends leaves 45 us later"; malloc'd. */
char *delay_words(const struct delay *d, uint32_t nodes);
/* The word of a kind in schedule files: "message". */
const char *delay_kind_name(enum delay_kind kind);
/* Do items of that kind have an index? */
int delay_kind_is_indexed(enum delay_kind kind);
#endif
