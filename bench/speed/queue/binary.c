/* binary.c - the textbook's heap in an array. */
#include <stdlib.h>
#include "queues.h"

struct binary {
    struct item *at; /* from 1 */
    size_t count, room;
};

static void *make(void)
{
    return calloc(1, sizeof(struct binary));
}

static void put(void *queue, struct item e)
{
    struct binary *q = queue;
    if (q->count + 2 > q->room) {
        q->room = 2 * q->room + 64;
        q->at = realloc(q->at, q->room * sizeof *q->at);
    }
    size_t i = ++q->count;
    for (; i > 1 && item_before(e, q->at[i / 2]); i /= 2)
        q->at[i] = q->at[i / 2];
    q->at[i] = e;
}

static struct item take(void *queue)
{
    struct binary *q = queue;
    struct item first = q->at[1], last = q->at[q->count--];
    size_t i = 1;
    for (size_t child; (child = 2 * i) <= q->count; i = child) {
        if (child < q->count)
            child += (size_t)item_before(q->at[child + 1], q->at[child]);
        if (!item_before(q->at[child], last))
            break;
        q->at[i] = q->at[child];
    }
    q->at[i] = last;
    return first;
}

static void drop(void *queue)
{
    free(((struct binary *)queue)->at);
    free(queue);
}

const struct queue BINARY_HEAP = {"binary heap", make, put, take, drop};
