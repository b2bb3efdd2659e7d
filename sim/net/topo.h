/* topo.h - the shape of the network: which channels a message crosses, in which order.
 *
 * Hypercube: e-cube routes, from the lowest differing bit up. Mesh: along the row first, then along the
 * column; nodes are numbered row by row. Channels are directed (full duplex); each node also has one port
 * into and one out of the network, which are the first and the last channel of every route.
 *
 * Services (I/O nodes, the directory of their file system) hang on the same network, at addresses of their
 * own, numbered from `positions` up:
 *   mesh        columns added at the right edge of the rectangle, filled downward, then outward: addresses
 *               of a larger mesh, with the same routes.
 *                   0  1  2 | 9  12
 *                   3  4  5 | 10 13      3 x 3 nodes, 5 services: 9 to 13
 *                   6  7  8 | 11 .
 *   hypercube   each on a channel (one each way) of its own from a node, spread evenly: service i of n on
 *               node i * positions / n. A route to it is that node's, then its channel.
 * In both, every route takes classes of channels in one order (in, e-cube dimensions or row then column,
 * out), so that there is no cycle of channels waiting for each other.
 */
#ifndef NET_TOPO_H
#define NET_TOPO_H
#include <stdbool.h>
#include <stdint.h>

/* Of a network, at most: a node, service or host takes one. (An event's key has room for so many.) */
enum { TOPO_ADDRESSES = 1 << 20 };

struct topo {
    uint32_t nodes;         /* of the program */
    uint32_t dimension;     /* hypercube: > 0 or one node; mesh: 0 */
    uint32_t rows, columns; /* mesh: the rectangle; hypercube: 0 */
    uint64_t a_column;      /* 2^40 / columns, rounded up */
    uint32_t positions;     /* nodes of the whole cube or rectangle, >= nodes */
    uint32_t services;      /* at the addresses positions .. positions + services - 1 */
    bool host; /* the last address is the host's: on a channel (one each way) of its own from node 0 */
    uint32_t addresses; /* in use for nodes, services and host: 0 .. addresses - 1 */
    uint32_t channels;
};

/* Makes the smallest cube with n nodes or more. Returns false if n is 0, or the cube needs more than
 * max_dimension. */
bool topo_hypercube(struct topo *t, uint32_t n, uint32_t max_dimension);
/* Makes the rectangle of least area, then least girth, that holds n nodes and fits in rows x columns. Returns
 * false if there is none. */
bool topo_mesh(struct topo *t, uint32_t n, uint32_t rows, uint32_t columns);

/* Adds n services to a shape that has none. */
void topo_add_services(struct topo *t, uint32_t n);

/* Adds the host to a hypercube, after its services; its address is topo_host(). */
void topo_add_host(struct topo *t);
static inline uint32_t topo_host(const struct topo *t)
{
    return t->addresses - 1;
}
static inline bool topo_is_host(const struct topo *t, uint32_t address)
{
    return t->host && address == topo_host(t);
}

/* Hops between two addresses, ports not counted. */
uint32_t topo_hops(const struct topo *t, uint32_t from, uint32_t to);

/* What a channel is. */
enum topo_kind { TOPO_LINK, TOPO_IN, TOPO_OUT };
struct topo_channel {
    enum topo_kind kind;
    /* A link's ends; of a port, which leads into or out of the network, both its address. */
    uint32_t from, to;
};
struct topo_channel topo_channel(const struct topo *t, uint32_t channel);

/* A route under way: the channels from one address to another, one at a time. They come in runs, whose
 * channels are at equal distances: the part of a row of a mesh is one, and that of a column. */
struct topo_walk {
    uint32_t at, to;             /* at: where the run ends */
    uint32_t x, y, to_x, to_y;   /* the same in a mesh */
    uint32_t next, stride, left; /* of the run: the next channel, the distance, and how many are left */
    bool entered, ended;         /* the runs of the ports have begun */
};
void topo_begin(const struct topo *t, struct topo_walk *w, uint32_t from, uint32_t to);
/* Begins the route's next run; returns false when the route is complete. */
bool topo_turn(const struct topo *t, struct topo_walk *w);
/* Sets *channel to the next channel of the route; returns false when the route is complete. */
static inline bool topo_step(const struct topo *t, struct topo_walk *w, uint32_t *channel)
{
    if (!w->left && !topo_turn(t, w))
        return false;
    *channel = w->next;
    w->next += w->stride;
    w->left--;
    return true;
}
#endif
