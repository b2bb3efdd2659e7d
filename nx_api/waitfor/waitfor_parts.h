/* waitfor_parts.h - what the files of this folder share. */
#ifndef WAITFOR_WAITFOR_PARTS_H
#define WAITFOR_WAITFOR_PARTS_H
#include "nx_api/waitfor/waitfor.h"

/* As malloc's family, but abort() without memory. */
void *waitfor_alloc(size_t count, size_t bytes);
void *waitfor_grow(void *block, size_t count, size_t bytes);
/* Room for one more of count elements: it grows when count is a power of two. */
void *waitfor_room(void *array, size_t count, size_t bytes);
/* A stream into memory: *text is there, and the caller's to free, when it has been closed. */
FILE *waitfor_stream(char **text, size_t *size);

/* Does a typesel select a type; a selector a message of this type, node and process type? */
bool waitfor_type_selected(long typesel, long type);
bool waitfor_selects(const struct waitfor_select *s, long type, long from, long pid);

/* Of MPI's: is this process type that of a communicator's collectives? */
bool waitfor_is_collective(long pid);
/* Does the node wait for a message of one? */
bool waitfor_in_collective(const struct waitfor_node *n);

/* Has the message to do with the node's wait: is it neither of NX's library nor, unless the node is in a
 * collective of MPI's, of such a one? */
bool waitfor_concerns(const struct waitfor_node *n, const struct waitfor_message *m);

/* For people: "type 7", "any type", "one of the types 3, 5"; "node 3", "any node", "the host". */
void waitfor_print_typesel(FILE *f, long typesel);
/* Of MPI's: is this process type a communicator's? A message's tag, communicator and sender; what to do about
 * the wait, NULL: nothing of MPI's own. */
void waitfor_print_mpi(FILE *f, const struct waitfor *w, long tag, long node, long pid);
/* "the lock of node 1's memory in window 2: node 0 has it" */
void waitfor_print_lock(FILE *f, const struct waitfor *w, const struct waitfor_node *n);
const char *waitfor_mpi_remedy(const struct waitfor_node *n);
void waitfor_print_node(FILE *f, const struct waitfor *w, long node);
/* "29.456789 ms": the simulator writes moments in this way, too (sim/files/virtual_time.h). */
void waitfor_print_time(FILE *f, uint64_t ps);
/* Neighbours from first to end - 1. */
struct waitfor_run {
    uint32_t first, end;
};
/* A set of nodes, which may have the host, too. */
struct waitfor_set {
    struct waitfor_run *runs; /* without the host; the caller's to free */
    uint32_t run_count, nodes;
    long host; /* its number; WAITFOR_ANY: it is not in the set */
};
/* The nodes i of which is(w, i, arg) is true. */
typedef bool waitfor_choice(const struct waitfor *w, uint32_t i, const void *arg);
struct waitfor_set waitfor_choose(const struct waitfor *w, waitfor_choice *is, const void *arg);
/* "node 3", "nodes 1-5, 7", "nodes 0, 2, ..., 510", "the host", and "none" of no node: the set without `but`,
 * which is in it (WAITFOR_ANY: all of it). In time proportional to the runs. */
void waitfor_print_set(FILE *f, const struct waitfor_set *s, long but);
void waitfor_print_nodes(FILE *f, const struct waitfor *w, waitfor_choice *is, const void *arg);

/* Steps of the analysis, in this order. */
void waitfor_find_whom(struct waitfor *w);
void waitfor_find_cycle(struct waitfor *w);
void waitfor_find_causes(struct waitfor *w);
void waitfor_find_reasons(struct waitfor *w);
/* Could the node still do something for others: has it a program that has not ended? */
static inline bool waitfor_lives(const struct waitfor_node *n)
{
    return n->state == WAITFOR_WAITS || n->state == WAITFOR_COMPUTES;
}
/* Does the node wait for a message of the host, whose number is that of the nodes, and there is none? */
bool waitfor_lacks_host(const struct waitfor *w, const struct waitfor_node *n);
/* What explains a node's wait for a message: the latest of those it has had; a receive under way that has it.
 * NULL: none. */
const struct waitfor_taken *waitfor_taken_away(const struct waitfor_node *n);
const struct waitfor_receive *waitfor_held_by(const struct waitfor_node *n);
/* "ended", and with which error. */
void waitfor_print_ended(FILE *f, const struct waitfor_node *n);
/* Is it awaited by the nodes in this operation? */
bool waitfor_is_missed(const struct waitfor *w, uint32_t i, const void *operation);
#endif
