/* queues.h - many queues, each found by a number: of messages, say, by sender or by type. What is in a queue
 * has its order there; mostly it is added behind the last and taken as the first. For lists that have become
 * long: a few things are looked through sooner. */
#ifndef KERNEL_QUEUES_H
#define KERNEL_QUEUES_H
#include <stdint.h>

struct queues;

struct queues *queues_new(void);
void queues_free(struct queues *q); /* q may be NULL */
/* item is in the queue by this number, behind those of a smaller order; and no more. */
void queues_add(struct queues *q, uint32_t number, int64_t order, void *item);
void queues_remove(struct queues *q, uint32_t number, const void *item);
/* The i-th of a queue, from 0. NULL: there are not so many. */
void *queues_at(const struct queues *q, uint32_t number, uint32_t i);
#endif
