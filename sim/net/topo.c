/* topo.c - see topo.h. Channel numbers: the links of node i first, then all ports in, then all ports out,
 * then what each service has. */
#include "net/topo.h"
#include <assert.h>
#include <stdlib.h>

enum { EAST, WEST, SOUTH, NORTH, MESH_LINKS };
enum { CUBE_SERVICE = 2, MESH_SERVICE = MESH_LINKS + 2 }; /* channels of a service; the last two: in, out */

static uint32_t links(const struct topo *t)
{
    return t->rows ? MESH_LINKS : t->dimension;
}

static void count_channels(struct topo *t)
{
    t->addresses = t->positions;
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
        uint32_t c = (n - 1) / r + 1, area = r * c;
        if (c > columns)
            continue;
        if (!t->rows || area < t->positions || (area == t->positions && r + c < t->rows + t->columns))
            t->rows = r, t->columns = c, t->positions = area;
    }
    if (t->rows)
        t->a_column = ((UINT64_C(1) << 40) + t->columns - 1) / t->columns;
    count_channels(t);
    return t->rows > 0;
}

/* The mesh's added columns are whole: a route may pass where no service is. */
void topo_add_services(struct topo *t, uint32_t n)
{
    assert(t->services == 0);
    uint32_t routers = t->rows ? (n + t->rows - 1) / t->rows * t->rows : n;
    t->services = n;
    t->addresses = t->positions + n;
    t->channels += routers * (t->rows ? MESH_SERVICE : CUBE_SERVICE);
}

void topo_add_host(struct topo *t)
{
    assert(!t->rows && !t->host);
    t->host = true;
    t->addresses++;
    t->channels += CUBE_SERVICE;
}

/* --- the mesh, with its added columns --- */

struct spot {
    uint32_t x, y;
};

static struct spot spot_of(const struct topo *t, uint32_t address)
{
    if (address < t->positions) {
        uint32_t y = (uint32_t)(address * t->a_column >> 40); /* address / columns: both are less than 2^20 */
        return (struct spot){address - y * t->columns, y};
    }
    uint32_t i = address - t->positions;
    return (struct spot){t->columns + i / t->rows, i % t->rows};
}

static uint32_t address_of(const struct topo *t, struct spot s)
{
    return s.x < t->columns ? s.y * t->columns + s.x : t->positions + (s.x - t->columns) * t->rows + s.y;
}

/* The node of a hypercube at which an address enters and leaves the cube. */
static uint32_t cube_node(const struct topo *t, uint32_t address)
{
    if (address < t->positions)
        return address;
    if (topo_is_host(t, address))
        return 0;
    return (uint32_t)((uint64_t)(address - t->positions) * t->positions / t->services);
}

static uint32_t distance(uint32_t a, uint32_t b)
{
    return (uint32_t)abs((int)(a - b)); /* both are less than 2^20 */
}

uint32_t topo_hops(const struct topo *t, uint32_t from, uint32_t to)
{
    if (!t->rows)
        return (uint32_t)__builtin_popcount(cube_node(t, from) ^ cube_node(t, to)) + (from >= t->positions) +
               (to >= t->positions);
    struct spot a = spot_of(t, from), b = spot_of(t, to);
    return distance(a.x, b.x) + distance(a.y, b.y);
}

/* --- channels: those of a kind lie side by side, as neighbours use the same kind at the same time --- */

/* The first channel that belongs to a service, or to an empty router. */
static uint32_t service_channels(const struct topo *t, uint32_t address)
{
    return t->positions * (links(t) + 2) + (address - t->positions) * (t->rows ? MESH_SERVICE : CUBE_SERVICE);
}

/* The port into (out = 0) or out of (out = 1) the network. A hypercube's service has its channel for port. */
static uint32_t port(const struct topo *t, uint32_t address, uint32_t out)
{
    if (address >= t->positions)
        return service_channels(t, address) + (t->rows ? MESH_LINKS : 0) + out;
    return t->positions * (links(t) + out) + address;
}

static uint32_t mesh_link(const struct topo *t, uint32_t address, uint32_t way)
{
    return address < t->positions ? way * t->positions + address : service_channels(t, address) + way;
}

void topo_begin(const struct topo *t, struct topo_walk *w, uint32_t from, uint32_t to)
{
    *w = (struct topo_walk){.at = from, .to = to};
    if (!t->rows)
        return;
    struct spot a = spot_of(t, from), b = spot_of(t, to);
    w->x = a.x, w->y = a.y, w->to_x = b.x, w->to_y = b.y;
}

/* The address that a mesh's link leads to. */
static uint32_t mesh_neighbour(const struct topo *t, uint32_t address, uint32_t way)
{
    struct spot s = spot_of(t, address);
    s.x += way == EAST ? 1 : way == WEST ? -1 : 0;
    s.y += way == SOUTH ? 1 : way == NORTH ? -1 : 0;
    return address_of(t, s);
}

/* A channel of the nodes': those of a kind lie side by side. */
static struct topo_channel node_channel(const struct topo *t, uint32_t channel)
{
    uint32_t way = channel / t->positions, address = channel % t->positions;
    if (way >= links(t))
        return (struct topo_channel){way == links(t) ? TOPO_IN : TOPO_OUT, address, address};
    return (struct topo_channel){TOPO_LINK, address,
                                 t->rows ? mesh_neighbour(t, address, way) : address ^ UINT32_C(1) << way};
}

struct topo_channel topo_channel(const struct topo *t, uint32_t channel)
{
    uint32_t nodes = t->positions * (links(t) + 2), each = t->rows ? MESH_SERVICE : CUBE_SERVICE;
    if (channel < nodes)
        return node_channel(t, channel);
    uint32_t address = t->positions + (channel - nodes) / each, which = (channel - nodes) % each;
    uint32_t first_port = t->rows ? MESH_LINKS : 0;
    if (which < first_port)
        return (struct topo_channel){TOPO_LINK, address, mesh_neighbour(t, address, which)};
    return (struct topo_channel){which == first_port ? TOPO_IN : TOPO_OUT, address, address};
}

static void turn_in_hypercube(const struct topo *t, struct topo_walk *w)
{
    uint32_t bit = (uint32_t)__builtin_ctz(w->at ^ cube_node(t, w->to));
    w->next = bit * t->positions + w->at;
    w->at ^= UINT32_C(1) << bit;
}

/* Within the rectangle the links of a row, or column, are one run; outside each is a run of its own. */
static void turn_in_mesh(const struct topo *t, struct topo_walk *w)
{
    bool inside = w->at < t->positions, along_row = w->x != w->to_x;
    bool up = along_row ? w->x < w->to_x : w->y < w->to_y;
    if (along_row && inside)
        w->left = distance(w->x, up && w->to_x > t->columns ? t->columns : w->to_x);
    else if (inside)
        w->left = distance(w->y, w->to_y);
    w->next = mesh_link(t, w->at, along_row ? (up ? EAST : WEST) : (up ? SOUTH : NORTH));
    w->stride = along_row ? 1 : t->columns;
    uint32_t by = w->left;
    if (!up)
        w->stride = -w->stride, by = -by;
    if (along_row)
        w->x += by;
    else
        w->y += by;
    w->at = address_of(t, (struct spot){w->x, w->y});
}

bool topo_turn(const struct topo *t, struct topo_walk *w)
{
    if (w->ended)
        return false;
    w->left = 1;
    if (!w->entered) {
        w->entered = true;
        w->next = port(t, w->at, 0);
        w->at = t->rows ? w->at : cube_node(t, w->at);
    } else if (w->at == (t->rows ? w->to : cube_node(t, w->to))) {
        w->ended = true;
        w->next = port(t, w->to, 1);
    } else if (t->rows) {
        turn_in_mesh(t, w);
    } else {
        turn_in_hypercube(t, w);
    }
    return true;
}
