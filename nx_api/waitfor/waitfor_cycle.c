/* waitfor_cycle.c - a shortest cycle of the wait-for graph, and whether it is a knot.
 *
 * The nodes in a global operation all wait for the same others. So the operation is a vertex of its own
 * between the two, and there are no more edges than nodes times operations:
 *
 *     node 0 --.              .--> node 3
 *     node 1 ---> (gsync) ---+
 *     node 2 --'              '--> node 4
 *
 * A cycle either has no operation in it, and then each of its nodes waits for one other: following the edges
 * finds it. Or it passes an operation, and then a search in breadth from that operation finds a shortest. */
#include <stdlib.h>
#include <string.h>
#include "nx_api/waitfor/waitfor_parts.h"

enum { UNSEEN = UINT32_MAX };

static bool waits(const struct waitfor *w, uint32_t i)
{
    return w->nodes[i].state == WAITFOR_WAITS;
}

/* --- cycles without an operation --- */

/* The cycle that begins and ends at a node, one of whom[] each. */
static void keep_circle(struct waitfor *w, uint32_t from)
{
    uint32_t count = 0, i = from;
    do {
        w->nodes[i].in_circle = true;
        i = w->nodes[i].whom;
        count++;
    } while (i != from);
    w->circles++;
    if (w->cycle && count >= w->cycle_count)
        return;
    w->cycle = waitfor_grow(w->cycle, count, sizeof *w->cycle);
    w->cycle_count = count;
    for (uint32_t k = 0; k < count; k++, i = w->nodes[i].whom)
        w->cycle[k] = i;
}

/* Each node is followed to where the way ends, or comes to a node seen before: in the same way, if that node
 * is in a cycle not yet known. */
static void find_circles(struct waitfor *w)
{
    uint32_t *way = waitfor_alloc(w->count, sizeof *way);
    memset(way, 0xff, w->count * sizeof *way);
    for (uint32_t first = 0; first < w->count; first++) {
        uint32_t i = first;
        while (way[i] == UNSEEN && waits(w, i) && w->nodes[i].who == WAITFOR_ONE_NODE) {
            way[i] = first;
            i = w->nodes[i].whom;
        }
        if (way[i] == first)
            keep_circle(w, i);
    }
    free(way);
}

/* --- cycles with operations --- */

struct search {
    const char *from;
    uint32_t *before; /* the node that waits for this one; itself: it is the first. UNSEEN */
    uint32_t *queue, head, tail;
    const char **passed; /* operations from which the search has gone on */
    uint32_t passed_count;
};

static void reach(struct search *s, const struct waitfor *w, uint32_t i, uint32_t before)
{
    if (s->before[i] != UNSEEN || !waits(w, i))
        return;
    s->before[i] = before;
    s->queue[s->tail++] = i;
}

static bool has_passed(const struct search *s, const char *operation)
{
    for (uint32_t k = 0; k < s->passed_count; k++)
        if (s->passed[k] == operation)
            return true;
    return false;
}

/* All that an operation waits for. before UNSEEN: each is a first one. */
static void pass(struct search *s, const struct waitfor *w, const char *operation, uint32_t before)
{
    if (has_passed(s, operation))
        return;
    s->passed = waitfor_room(s->passed, s->passed_count, sizeof *s->passed);
    s->passed[s->passed_count++] = operation;
    for (uint32_t i = 0; i < w->count; i++)
        if (waitfor_is_missed(w, i, operation))
            reach(s, w, i, before == UNSEEN ? i : before);
}

/* From the last node of a cycle back to the first. */
static void keep_way(struct waitfor *w, const struct search *s, uint32_t last)
{
    uint32_t count = 1;
    for (uint32_t i = last; s->before[i] != i; i = s->before[i])
        count++;
    if (w->cycle && count >= w->cycle_count)
        return;
    w->cycle = waitfor_grow(w->cycle, count, sizeof *w->cycle);
    w->cycle_count = count;
    for (uint32_t k = count, i = last; k-- > 0; i = s->before[i])
        w->cycle[k] = i;
}

static void find_through(struct waitfor *w, struct search *s, const char *operation)
{
    memset(s->before, 0xff, w->count * sizeof *s->before);
    s->head = s->tail = s->passed_count = 0;
    pass(s, w, operation, UNSEEN);
    while (s->head < s->tail) {
        uint32_t i = s->queue[s->head++];
        const struct waitfor_node *n = &w->nodes[i];
        if (n->operation == operation) {
            keep_way(w, s, i);
            return;
        }
        if (n->who == WAITFOR_ONE_NODE)
            reach(s, w, n->whom, i);
        else if (n->who == WAITFOR_ALL_NODES)
            pass(s, w, n->operation, i);
    }
}

/* Through each operation, at its first node. */
static void find_through_operations(struct waitfor *w)
{
    struct search s = {.before = waitfor_alloc(w->count, sizeof *s.before),
                       .queue = waitfor_alloc(w->count, sizeof *s.queue)};
    const char **done = waitfor_alloc(w->count, sizeof *done);
    size_t count = 0;
    for (uint32_t i = 0; i < w->count; i++) {
        const char *operation = w->nodes[i].operation;
        size_t k = 0;
        while (k < count && done[k] != operation)
            k++;
        if (!operation || k < count)
            continue;
        done[count++] = operation;
        find_through(w, &s, operation);
    }
    free(done);
    free(s.before);
    free(s.queue);
    free(s.passed);
}

/* The lowest node first. */
static void turn(struct waitfor *w)
{
    uint32_t lowest = 0, *turned = waitfor_alloc(w->cycle_count, sizeof *turned);
    for (uint32_t k = 0; k < w->cycle_count; k++)
        lowest = w->cycle[k] < w->cycle[lowest] ? k : lowest;
    for (uint32_t k = 0; k < w->cycle_count; k++)
        turned[k] = w->cycle[(lowest + k) % w->cycle_count];
    free(w->cycle);
    w->cycle = turned;
}

/* --- knots --- */

/* From a node that any other could free, each that waits can be reached. So all that wait are a knot if from
 * each of them such a node can be reached. Where there is no cycle, each way along the edges comes to an end,
 * and what is known of its end holds for all of it. */
enum answer { UNKNOWN, NO, YES };

struct knot {
    const struct waitfor *w;
    unsigned char *node;    /* enum answer of each */
    const char **operation; /* those that are answered */
    unsigned char *answer;
    uint32_t operations;
};

static enum answer reaches_any(struct knot *k, uint32_t i);

static enum answer one_of_missed(struct knot *k, const char *operation)
{
    for (uint32_t i = 0; i < k->w->count; i++)
        if (waitfor_is_missed(k->w, i, operation) && reaches_any(k, i) == YES)
            return YES;
    return NO;
}

static enum answer operation_reaches(struct knot *k, const char *operation)
{
    for (uint32_t i = 0; i < k->operations; i++)
        if (k->operation[i] == operation)
            return k->answer[i];
    enum answer found = one_of_missed(k, operation);
    k->operation[k->operations] = operation;
    k->answer[k->operations++] = (unsigned char)found;
    return found;
}

static enum answer end_reaches(struct knot *k, uint32_t i)
{
    const struct waitfor_node *n = &k->w->nodes[i];
    if (!waits(k->w, i))
        return NO;
    if (n->who == WAITFOR_ALL_NODES)
        return operation_reaches(k, n->operation);
    return n->who == WAITFOR_ANY_NODE ? YES : NO;
}

static enum answer reaches_any(struct knot *k, uint32_t i)
{
    uint32_t end = i;
    while (!k->node[end] && waits(k->w, end) && k->w->nodes[end].who == WAITFOR_ONE_NODE)
        end = k->w->nodes[end].whom;
    if (!k->node[end])
        k->node[end] = (unsigned char)end_reaches(k, end);
    for (; i != end; i = k->w->nodes[i].whom)
        k->node[i] = k->node[end];
    return k->node[end];
}

/* Does a node wait for one that does not wait itself? Such a node ends all ways. All global operations wait
 * for each node without a wait, but for the host. */
static bool any_leads_out(const struct waitfor *w)
{
    bool computes = false, missed = false;
    for (uint32_t i = 0; i < w->count; i++) {
        computes |= w->nodes[i].state == WAITFOR_COMPUTES;
        missed |= !waits(w, i) && !w->nodes[i].is_host;
    }
    for (uint32_t i = 0; i < w->count; i++) {
        const struct waitfor_node *n = &w->nodes[i];
        if (waits(w, i) && (n->who == WAITFOR_ONE_NODE    ? !waits(w, n->whom)
                            : n->who == WAITFOR_ALL_NODES ? missed
                                                          : computes))
            return true;
    }
    return false;
}

static bool is_knot(const struct waitfor *w)
{
    if (any_leads_out(w))
        return false;
    struct knot k = {.w = w,
                     .node = waitfor_alloc(w->count, 1),
                     .operation = waitfor_alloc(w->count, sizeof *k.operation),
                     .answer = waitfor_alloc(w->count, 1)};
    uint32_t waiting = 0, reach = 0;
    for (uint32_t i = 0; i < w->count; i++)
        if (waits(w, i)) {
            waiting++;
            reach += reaches_any(&k, i) == YES;
        }
    free(k.node);
    free(k.operation);
    free(k.answer);
    return waiting > 1 && reach == waiting;
}

void waitfor_find_cycle(struct waitfor *w)
{
    find_circles(w);
    find_through_operations(w);
    if (w->cycle)
        turn(w);
    else
        w->knot = is_knot(w);
    for (uint32_t k = 0; k < w->cycle_count; k++)
        w->nodes[w->cycle[k]].in_cycle = true;
}
