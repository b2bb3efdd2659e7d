/* plan.h - what a schedule says (doc/schedule-format.md): by how much what a run's nodes do is delayed, and
 * which orders the run must keep. */
#ifndef TIMING_PLAN_H
#define TIMING_PLAN_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "kernel/vtime.h"

/* About the k-th of a node, from 0: its message or its handler that becomes due, which is so much later; its
 * receive, which gets the nth message that `from` has sent to the node; its handler, which runs when its
 * program has begun so many calls. */
struct plan_item {
    uint64_t k;
    union {
        vtime later;
        uint64_t nth, calls;
    };
    uint32_t from; /* plan.nodes: the host */
    unsigned line; /* of the file */
};

/* Ascends by k, and has each once. */
struct plan_list {
    struct plan_item *item;
    size_t count;
};

struct plan_node {
    uint32_t speed_ppm; /* the node computes slower by so many parts per million */
    vtime start;        /* its program begins so much later */
    struct plan_list messages, interrupts;
    struct plan_list matches, handlers; /* empty unless the plan has orders */
    struct plan_list by_message;        /* the matches, which ascend by `from`, and then by nth; each once */
};

struct plan {
    char *path;  /* of the file, for errors */
    bool orders; /* what its lines match and handler say must happen */
    bool delays; /* they only tell of a run that the delays repeat */
    bool has_program;
    uint32_t program; /* the number of the program that was recorded: elf_loaded_sum(), guest/elffile.h */
    uint32_t nodes;
    struct plan_node *node; /* nodes, and the host behind them */
};

/* Sorts the lists, and makes by_message. Returns 0, or the line of an item about the same as another. */
unsigned plan_sort(struct plan *p);
/* The item about the k-th; of a list by_message, about the nth message of a node. NULL: there is none. */
const struct plan_item *plan_find(const struct plan_list *l, uint64_t k);
const struct plan_item *plan_find_message(const struct plan_list *l, uint32_t from, uint64_t nth);
void plan_free(struct plan *p);
#endif
