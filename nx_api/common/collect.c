/* collect.c - gcolx and gcol: all nodes' vectors, one after the other, on all nodes.
 *
 * Every vector has its position in the result, so nodes forward a part of the result as it lies in memory.
 * Let p be the largest power of two that is no more than the number of nodes n, and r = n - p. The first 2 r
 * nodes form r pairs, and each other node is alone: p groups, in the order of the nodes. The second node of a
 * pair first sends its vector to the first. In step k the first nodes of groups whose numbers differ in bit k
 * exchange what they have, which is the vectors of 2^k adjacent groups. At the end the first node of each
 * pair sends the result to the second. With 6 nodes:
 *
 *     node      0     1     2     3     4     5
 *     group     0     '     1     '     2     3
 *     fold      <-----'     <-----'
 *     bit 0     <----------->           <----->
 *     bit 1     <----------------------->
 *                           <----------------->
 *     tell      ----->      ----->
 *
 * Message types are as in global.c: a node gets messages of one type from one other node only.
 */
#include <errno.h>
#include <string.h>
#include "global.h"
#include "nx.h"

enum { FOLD = 62, TELL = 63 };

struct groups {
    long p, r;
};

static struct groups groups_of(long nodes)
{
    long p = 1;
    while (p <= nodes / 2)
        p *= 2;
    return (struct groups){p, nodes - p};
}

/* The first node of a group; of group p: the number of nodes. */
static long first(struct groups g, long group)
{
    return group < g.r ? 2 * group : group + g.r;
}

struct collection {
    long type;      /* of step 0 */
    char *y;        /* the result */
    const long *at; /* at[i]: where in it node i's vector begins; at[numnodes()] its end */
};

static void exchange(const struct collection *c, struct groups g, long step, long mine, long theirs)
{
    long bit = 1L << step, my_first = mine & -bit, their_first = theirs & -bit;
    long from = c->at[first(g, my_first)], to = c->at[first(g, my_first + bit)];
    long in = c->at[first(g, their_first)], in_end = c->at[first(g, their_first + bit)];
    long id = irecv(c->type + step, c->y + in, in_end - in);
    csend(c->type + step, c->y + from, to - from, first(g, theirs), 0);
    msgwait(id);
}

/* This node's vector is at its position in the result. */
static void collect(const struct collection *c)
{
    long me = mynode(), nodes = numnodes();
    const long *at = c->at;
    struct groups g = groups_of(nodes);
    long mine = me < 2 * g.r ? me / 2 : me - g.r;
    if (me != first(g, mine)) {
        csend(c->type + FOLD, c->y + at[me], at[me + 1] - at[me], me - 1, 0);
        crecv(c->type + TELL, c->y, at[nodes]);
        return;
    }
    if (mine < g.r)
        crecv(c->type + FOLD, c->y + at[me + 1], at[me + 2] - at[me + 1]);
    for (long bit = 1, step = 0; bit < g.p; bit *= 2, step++)
        exchange(c, g, step, mine, mine ^ bit);
    if (mine < g.r)
        csend(c->type + TELL, c->y, at[nodes], me + 1, 0);
}

/* 0, or what is wrong. */
static int collect_of(long operation, const void *x, const long lens[], char *y, long room, long *total)
{
    long me = mynode(), nodes = numnodes(), at[nodes + 1];
    at[0] = 0;
    for (long i = 0; i < nodes; i++) {
        if ((int)lens[i] < 0)
            return EQLEN;
        at[i + 1] = at[i] + (int)lens[i];
    }
    if (total)
        *total = at[nodes];
    if (room >= 0 && at[nodes] > room)
        return EQBLEN;
    if ((at[me + 1] > at[me] && !x) || (at[nodes] > 0 && !y))
        return EQPBUF;
    memmove(y + at[me], x, (size_t)(at[me + 1] - at[me]));
    const struct collection c = {GLOBAL_FIRST_TYPE + operation * GLOBAL_TYPES, y, at};
    collect(&c);
    return 0;
}

static int collect_known(const void *x, const long lens[], void *y)
{
    return lens ? collect_of(GLOBAL_GCOL, x, lens, y, -1, NULL) : EQPBUF;
}

static int collect_unknown(const void *x, long len, void *y, long room, long *total)
{
    long nodes = numnodes(), lens[nodes], sizes[nodes];
    if (len < 0 || room < 0)
        return EQLEN;
    for (long i = 0; i < nodes; i++)
        sizes[i] = sizeof len;
    collect_of(GLOBAL_GCOL_LENGTHS, &len, sizes, (char *)lens, -1, NULL);
    return collect_of(GLOBAL_GCOL, x, lens, y, room, total);
}

/* --- the calls --- */

void gcolx(const void *x, const long lens[], void *y)
{
    int error = collect_known(x, lens, y);
    if (error)
        nx_fail("gcolx", error);
}

long _gcolx(const void *x, const long lens[], void *y)
{
    return nx_result(collect_known(x, lens, y));
}

void gcol(const void *x, long len, void *y, long room, long *total)
{
    int error = collect_unknown(x, (int)len, y, (int)room, total);
    if (error)
        nx_fail("gcol", error);
}

long _gcol(const void *x, long len, void *y, long room, long *total)
{
    return nx_result(collect_unknown(x, (int)len, y, (int)room, total));
}
