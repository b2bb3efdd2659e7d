/* run_summary.h - counts what each node does, and tells it at the end of a run: messages, waits, handlers.
 *
 * The environment variables NX_SUMMARY (for people, on node 0's standard error) and NX_SUMMARY_JSON (a file), on node 0,
 * turn it on for all nodes. Each sends its counts to node 0 when its program ends; node 0 writes them when all have. */
#ifndef MPI_RUN_SUMMARY_H
#define MPI_RUN_SUMMARY_H
#include "backend_node.h"

extern bool summary_wanted __attribute__((visibility("hidden")));

/* On all nodes, once. */
void summary_begin(struct node *n);

/* For runs with a summary only: call these through the macro. */
#define SUMMARY(what, ...)                                                                                   \
    do {                                                                                                     \
        if (__builtin_expect(summary_wanted, 0))                                                             \
            summary_##what(__VA_ARGS__);                                                                     \
    } while (0)

/* The program sends a message, to a node or -1: all others. */
void summary_send(const struct node *n, long node, size_t bytes);
/* The program waits in a call, and goes on. Handlers may run between the two. */
void summary_wait(void);
void summary_go_on(const struct node *n);
/* A handler begins, and has ended. */
void summary_handler(void);
void summary_handled(void);
/* The program ends with an error. */
void summary_fail(void);
/* This node's program has ended, with its status: sends its counts to node 0. */
void summary_end(struct node *n, int status);
/* They have come to node 0, from a node. */
void summary_part(uint32_t node, const void *bytes, size_t count);
/* On node 0: all programs have ended. */
void summary_write(struct node *n, bool deadlock);
#endif
