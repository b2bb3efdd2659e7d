/* modes.h - the place in a file of a node's call, by its I/O mode: the I/O modes and their pointers.
 *
 *   0  each node its own pointer
 *   1  one pointer for all; whoever asks first is served first
 *   2  one pointer for all; nodes are served in order 0, 1, ... n-1, 0, ...; lengths as they like
 *   3  as 2, but in a round all nodes give the same length: each knows its position without asking
 *   4  each node its own, which all move alike: one call serves all (unison.h)
 *   5  as 0
 *
 * One group of nodes shares a pointer in each mode of a file: it starts where its first member's own pointer
 * was, and ends when its last member leaves. Pure arithmetic; directory.c and operation.c take care of
 * messages and time.
 */
#ifndef CFS_MODES_H
#define CFS_MODES_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { MODE_OWN, MODE_FIRST_COME, MODE_ORDERED, MODE_RECORDS, MODE_UNISON, MODE_ASYNC, MODES };

/* Mode 3: a round of calls, one of each node. */
struct modes_round {
    uint64_t start, bytes; /* bytes a node */
    bool begun;            /* a node has made its call: start and bytes hold for all */
};

struct modes_group {
    uint32_t members;
    uint32_t generation; /* groups of this mode that there have been */
    uint64_t at;         /* modes 1, 2: the pointer */
    uint32_t turn;       /* mode 2: the node whose turn it is */
    struct modes_round *rounds;
    size_t round_count;
};

struct modes {
    struct modes_group group[MODES]; /* [MODE_OWN] is not used */
};

void modes_free(struct modes *m);

/* A node whose pointer was `at` joins the group of a mode, or leaves it. */
void modes_join(struct modes *m, int mode, uint64_t at);
void modes_leave(struct modes *m, int mode);

/* Modes 1 and 2: the position of a call of `bytes`; the pointer advances. */
uint64_t modes_take(struct modes_group *g, uint64_t bytes);
/* Mode 2: node's turn is over; the next one's begins. */
void modes_next_turn(struct modes_group *g, uint32_t nodes);

/* Mode 3: a call of `bytes` in a round (the node's own count of calls since it joined), by a node that has
 * sought to *sought in it (NULL: it has not). The round as the node that came first has it. */
struct modes_round modes_record(struct modes_group *g, uint64_t round, uint32_t nodes, const uint64_t *sought,
                                uint64_t bytes);
/* Mode 3: where the round before ends, as far as the earlier rounds have been called; and setting where a
 * round starts that has not begun. */
uint64_t modes_round_from(struct modes_group *g, uint64_t round, uint32_t nodes);
void modes_set_round(struct modes_group *g, uint64_t round, uint32_t nodes, uint64_t start);
#endif
