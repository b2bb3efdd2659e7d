/* order_record.h - records the order of a run, for touchstone run --replay: which message each receive
 * got, and behind how many calls each handler ran (doc/schedule-format.md, whose counts these are).
 *
 * The environment variable NX_RECORD on node 0 names the file, for all nodes. Each node keeps its part in
 * memory, 16 bytes for each receive and 8 for each handler, and sends it to node 0 at its end; node 0
 * writes the file. A process that ends by a signal writes its part itself, to FILE.NODE. */
#ifndef MPI_ORDER_RECORD_H
#define MPI_ORDER_RECORD_H
#include "backend_node.h"

/* Is the run recorded? And the calls that the program has begun outside of handlers. */
extern bool order_recorded __attribute__((visibility("hidden")));
extern uint64_t order_calls __attribute__((visibility("hidden")));

/* On all nodes, once. */
void record_begin(struct node *n);

/* For runs that are recorded only: call these through the macro. */
#define RECORD_ORDER(what, ...)                                                                              \
    do {                                                                                                     \
        if (__builtin_expect(order_recorded, 0))                                                             \
            record_##what(__VA_ARGS__);                                                                      \
    } while (0)

/* A message of a program has come to this node, from that node. */
void record_arrival(struct message *m);
/* A receive is made; gets a message; is withdrawn. */
void record_receive(struct receive *r);
void record_match(const struct receive *r, const struct message *m);
void record_withdraw(const struct receive *r);
/* A handler begins. */
void record_handler(void);
/* This node's program has ended: sends its part to node 0. */
void record_end(struct node *n);
/* A part has come to node 0: adds it to the file. */
void record_part(const void *bytes, size_t count);
/* In a signal handler: writes this node's part to a file of its own. */
void record_rescue(void);
#endif
