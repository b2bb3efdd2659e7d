/* race_hooks.h - what a node does that orders its handlers and its main program, or touches buffers, told to
 * the race checker (sim/races), which implements these functions. Programs built with nxcc --races have one.
 *
 * All are called on the node's stack, at the call's place in the total order: calls of such programs are not
 * deferred (gate.c). Only races_allocated() and races_freed() may be called on another thread than the
 * coordinator. */
#ifndef OS_RACE_HOOKS_H
#define OS_RACE_HOOKS_H
#include "node/system.h"

struct message;

/* For nodes with a race checker only: call these through the macro. */
#define RACES(n, what, ...)                                                                                  \
    do {                                                                                                     \
        if (__builtin_expect((n)->races != NULL, 0))                                                         \
            races_##what((n), ##__VA_ARGS__);                                                                \
    } while (0)

/* The program has left a call, or begins: it computes from now on. */
void races_computes(struct node *n);
/* It sends messages, linked by next. s: of isend or hsend, whose buffer is not to be written before the end;
 * of a call that waits; or NULL. */
void races_sends(struct node *n, const void *buf, size_t bytes, struct message *first, const struct send *s);
/* The id of an isend is given back. */
void races_sent(struct node *n, const struct send *s);
/* It posts a receive, withdraws it, or takes its message: about to be put into the buffer. */
void races_posts(struct node *n, const struct receive *r);
void races_withdraws(struct node *n, const struct receive *r);
void races_takes(struct node *n, const struct receive *r);
/* A handler begins, of a receive or a send (the other is NULL), before it takes its message; ends. */
void races_handler_begins(struct node *n, const struct receive *r, const struct send *s);
void races_handler_ends(struct node *n);
/* Handlers are masked, or let run. */
void races_masks(struct node *n, bool masked);
/* A call on a file reads the program's memory, or writes it. */
void races_moves(struct node *n, bool write, const void *at, size_t bytes);
/* The heap gives out memory; the program gives it back. */
void races_allocated(struct node *n, const void *at, size_t bytes);
void races_freed(struct node *n, const void *at, size_t bytes);
/* The host has loaded n, which is about to start. */
void races_loaded(struct node *n, struct node *host);
#endif
