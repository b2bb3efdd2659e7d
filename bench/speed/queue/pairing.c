/* pairing.c - a pairing heap: put makes one comparison, take melds the children in pairs. Fredman, Sedgewick,
 * Sleator, Tarjan, Algorithmica 1 (1986). */
#include <stdlib.h>
#include "queues.h"

struct node {
    struct item item;
    struct node *child, *next;
};

struct pairing {
    struct node *root, *spare;
};

static void *make(void)
{
    return calloc(1, sizeof(struct pairing));
}

static struct node *meld(struct node *a, struct node *b)
{
    if (item_before(b->item, a->item)) {
        struct node *t = a;
        a = b, b = t;
    }
    b->next = a->child;
    a->child = b;
    return a;
}

static void put(void *queue, struct item e)
{
    struct pairing *q = queue;
    struct node *n = q->spare;
    if (n)
        q->spare = n->next;
    else
        n = malloc(sizeof *n);
    *n = (struct node){.item = e};
    q->root = q->root ? meld(q->root, n) : n;
}

static struct item take(void *queue)
{
    struct pairing *q = queue;
    struct node *first = q->root, *pairs = NULL, *n = first->child;
    while (n) { /* pairs, from the left */
        struct node *a = n, *b = n->next;
        n = b ? b->next : NULL;
        a = b ? meld(a, b) : a;
        a->next = pairs;
        pairs = a;
    }
    struct node *root = pairs;
    if (root)
        pairs = root->next;
    while (pairs) { /* all pairs into one heap, from the right */
        n = pairs->next;
        root = meld(root, pairs);
        pairs = n;
    }
    q->root = root;
    first->next = q->spare;
    q->spare = first;
    return first->item;
}

static void free_all(struct node *n)
{
    while (n) {
        struct node *next = n->next;
        free_all(n->child);
        free(n);
        n = next;
    }
}

static void drop(void *queue)
{
    struct pairing *q = queue;
    for (struct node *n = q->spare, *next; n; n = next) {
        next = n->next;
        free(n);
    }
    if (q->root)
        q->root->next = NULL;
    free_all(q->root);
    free(q);
}

const struct queue PAIRING_HEAP = {"pairing heap", make, put, take, drop};
