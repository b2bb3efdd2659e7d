/* topo.c - see topo.h. Channel numbers: the links of node i first, then all ports in, then all ports out. */
#include "net/topo.h"

enum { EAST, WEST, SOUTH, NORTH, MESH_LINKS };

static uint32_t links(const struct topo *t)
{
    return t->rows ? MESH_LINKS : t->dimension;
}

static void count_channels(struct topo *t)
{
    t->channels = t->positions * (links(t) + 2);
}

bool topo_hypercube(struct topo *t, uint32_t n, uint32_t max_dimension)
{
    uint32_t d = 0;
    while (d < 31 && (UINT32_C(1) << d) < n)
        d++;
    if (n == 0 || d > max_dimension)
        return false;
    *t = (struct topo){.nodes = n, .dimension = d, .positions = UINT32_C(1) << d};
    count_channels(t);
    return true;
}

bool topo_mesh(struct topo *t, uint32_t n, uint32_t rows, uint32_t columns)
{
    *t = (struct topo){.nodes = n};
    for (uint32_t r = 1; n > 0 && r <= rows; r++) {
        uint32_t c = (n + r - 1) / r, area = r * c;
        if (c > columns)
            continue;
        if (!t->rows || area < t->positions || (area == t->positions && r + c < t->rows + t->columns))
            t->rows = r, t->columns = c, t->positions = area;
    }
    count_channels(t);
    return t->rows > 0;
}

static uint32_t distance(uint32_t a, uint32_t b)
{
    return a > b ? a - b : b - a;
}

uint32_t topo_hops(const struct topo *t, uint32_t from, uint32_t to)
{
    if (!t->rows)
        return (uint32_t)__builtin_popcount(from ^ to);
    return distance(from / t->columns, to / t->columns) + distance(from % t->columns, to % t->columns);
}

void topo_begin(struct topo_walk *w, uint32_t from, uint32_t to)
{
    *w = (struct topo_walk){.at = from, .to = to};
}

static uint32_t step_hypercube(const struct topo *t, struct topo_walk *w)
{
    uint32_t bit = (uint32_t)__builtin_ctz(w->at ^ w->to);
    uint32_t channel = w->at * t->dimension + bit;
    w->at ^= UINT32_C(1) << bit;
    return channel;
}

static uint32_t step_mesh(const struct topo *t, struct topo_walk *w)
{
    uint32_t c = t->columns, x = w->at % c, goal = w->to % c, from = w->at;
    if (x < goal)
        return w->at += 1, from * MESH_LINKS + EAST;
    if (x > goal)
        return w->at -= 1, from * MESH_LINKS + WEST;
    if (w->at < w->to)
        return w->at += c, from * MESH_LINKS + SOUTH;
    return w->at -= c, from * MESH_LINKS + NORTH;
}

bool topo_step(const struct topo *t, struct topo_walk *w, uint32_t *channel)
{
    uint32_t ports = t->positions * links(t);
    if (!w->entered) {
        w->entered = true;
        *channel = ports + w->at;
    } else if (w->at != w->to) {
        *channel = t->rows ? step_mesh(t, w) : step_hypercube(t, w);
    } else if (!w->left) {
        w->left = true;
        *channel = ports + t->positions + w->at;
    } else {
        return false;
    }
    return true;
}
