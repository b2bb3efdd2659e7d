/* channel_mesh.c - the channels of a mesh, drawn as it lies. Traffic keeps to the right: the channel to
 * the east runs below the one to the west. A node's square is its two ports. */
#include "lab/show/channel_mesh.h"
#include <math.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

enum {
    RIGHT = 150,  /* of the map, for the scale */
    DETAILED = 16 /* routers so far apart have outlines */
};
static const uint32_t UNUSED = 0xe9e9e9;

struct mesh {
    const struct channel_map *map;
    uint32_t bin;
    struct plot plot; /* of the routers' squares */
    double apart;     /* of routers */
    uint32_t columns; /* of routers */
};

/* With those of I/O nodes, if they were used. */
static uint32_t columns_of(const struct show *s)
{
    const struct topo *topo = &s->trace->topo;
    bool *shown = channel_map_shown(s);
    uint32_t last = topo->addresses;
    while (last > topo->positions && !shown[last - 1])
        last--;
    free(shown);
    return topo->columns + (last - topo->positions + topo->rows - 1) / topo->rows;
}

static double routers_apart(const struct show *s, uint32_t columns)
{
    return fmin(fmin((CANVAS_WIDTH - LEFT - RIGHT) / (double)columns, 560.0 / s->trace->topo.rows), 110);
}

double channel_mesh_height(const struct show *s)
{
    return fmax(10 + s->trace->topo.rows * routers_apart(s, columns_of(s)) + 70, 230);
}

static struct colour colour_of(const struct mesh *m, uint32_t channel)
{
    int level = heat_level(&m->map->heat, channel_use_share(&m->map->use, m->bin, channel));
    return level == HEAT_NONE ? COLOUR(UNUSED) : palette_level(level);
}

static bool is_drawn(const struct mesh *m, uint32_t address)
{
    return mesh_spot_of(&m->map->show->trace->topo, address).column < m->columns;
}

struct centre {
    double x, y;
};

static struct centre centre_of(const struct mesh *m, uint32_t address)
{
    struct mesh_spot s = mesh_spot_of(&m->map->show->trace->topo, address);
    return (struct centre){m->plot.x + (s.column + 0.5) * m->apart, m->plot.y + (s.row + 0.5) * m->apart};
}

/* Fills the path; in a small mesh, with an outline. */
static void fill_path(const struct canvas *c, const struct mesh *m, uint32_t channel)
{
    canvas_colour(c, colour_of(m, channel));
    cairo_fill_preserve(c->cr);
    canvas_colour(c, GREY);
    cairo_set_line_width(c->cr, 0.3);
    if (m->apart >= DETAILED)
        cairo_stroke(c->cr);
    cairo_new_path(c->cr);
}

/* An arrow from one router's square to the next; in a large mesh a bar. */
static void draw_link(const struct canvas *c, const struct mesh *m, uint32_t channel)
{
    /* of the distance between routers: along the channel, and to its right */
    static const double ARROW[][2] = {{0.27, 0.055},  {0.63, 0.055}, {0.63, 0.0165}, {0.73, 0.11},
                                      {0.63, 0.2035}, {0.63, 0.165}, {0.27, 0.165}},
                        BAR[][2] = {{0.24, 0.02}, {0.76, 0.02}, {0.76, 0.2}, {0.24, 0.2}};
    bool detailed = m->apart >= DETAILED;
    size_t count = detailed ? sizeof ARROW / sizeof *ARROW : sizeof BAR / sizeof *BAR;
    struct topo_channel ends = topo_channel(&m->map->show->trace->topo, channel);
    struct centre a = centre_of(m, ends.from), b = centre_of(m, ends.to);
    double dx = b.x - a.x, dy = b.y - a.y; /* one is 0; to the right is -dy, dx */
    for (size_t i = 0; i < count; i++) {
        const double *at = detailed ? ARROW[i] : BAR[i];
        cairo_line_to(c->cr, canvas_round(c, a.x + dx * at[0] - dy * at[1]),
                      canvas_round(c, a.y + dy * at[0] + dx * at[1]));
    }
    cairo_close_path(c->cr);
    fill_path(c, m, channel);
}

/* Half of a node's square: the upper one is the port into the network, the lower one that out of it. */
static void draw_port(const struct canvas *c, const struct mesh *m, uint32_t channel)
{
    struct topo_channel port = topo_channel(&m->map->show->trace->topo, channel);
    struct centre a = centre_of(m, port.from);
    double half = 0.22 * m->apart;
    cairo_rectangle(c->cr, a.x - half, port.kind == TOPO_IN ? a.y - half : a.y, 2 * half, half);
    fill_path(c, m, channel);
}

/* The colours' scale, right of the map. */
static struct plot scale_of(const struct mesh *m)
{
    return (struct plot){m->plot.x + m->plot.w + 20, m->plot.y + 22, 14,
                         fmin(fmax(m->plot.h - 26, 120), 300)};
}

/* The first node of each row, the numbers of the columns. */
static void draw_labels(const struct canvas *c, const struct mesh *m)
{
    const struct topo *topo = &m->map->show->trace->topo;
    const struct text_style left = {10, INK, ANCHOR_RIGHT, false}, below = {10, INK, ANCHOR_MIDDLE, false};
    uint32_t rows = m->apart < 12 ? 4 : 1, step = m->apart < 8    ? 8
                                                  : m->apart < 16 ? 4
                                                  : m->apart < 32 ? 2
                                                                  : 1;
    for (uint32_t r = 0; r < topo->rows; r += rows) {
        char *text = xasprintf("%u", r * topo->columns);
        canvas_text(c, m->plot.x - 6, m->plot.y + (r + 0.5) * m->apart + 3.5, left, text);
        free(text);
    }
    for (uint32_t i = 0; i < m->columns; i += step) {
        bool services = i >= topo->columns;
        char *text = services ? xstrdup("I/O") : xasprintf("+%u", i);
        canvas_text(c, m->plot.x + (i + 0.5) * m->apart, m->plot.y + m->plot.h + 14, below, text);
        free(text);
    }
    canvas_text_upward(c, m->plot.x - 48, m->plot.y + m->plot.h / 2,
                       (struct text_style){11, INK, ANCHOR_MIDDLE, false}, "first node of the row");
    struct plot scale = scale_of(m); /* longer than a map of one row */
    double below_all = fmax(m->plot.y + m->plot.h + 36, scale.y + scale.h + 24);
    canvas_text(c, m->plot.x, below_all, (struct text_style){10.5, INK, ANCHOR_LEFT, false},
                m->apart >= DETAILED
                    ? "Arrow: a channel between neighbours. Square: a node's ports, the upper half into the "
                      "network, the lower half out of it. Grey: not used."
                    : "Bar: a channel between neighbours; traffic keeps to the right. Square: a node's "
                      "ports, the upper half into the network. Grey: not used.");
}

void channel_mesh_draw(const struct channel_map *map, const struct canvas *c, double y, uint32_t bin)
{
    const struct topo *topo = &map->show->trace->topo;
    uint32_t columns = columns_of(map->show);
    double apart = routers_apart(map->show, columns);
    struct mesh m = {map, bin, {LEFT, y + 4, columns * apart, topo->rows * apart}, apart, columns};
    for (uint32_t channel = 0; channel < topo->channels; channel++) {
        struct topo_channel ends = topo_channel(topo, channel);
        if (!is_drawn(&m, ends.from) || (ends.kind == TOPO_LINK && !is_drawn(&m, ends.to)))
            continue;
        if (ends.kind != TOPO_LINK)
            draw_port(c, &m, channel);
        else if (channel_is_real(topo, channel))
            draw_link(c, &m, channel);
    }
    draw_labels(c, &m);
    heat_bar(c, scale_of(&m), &map->heat, HEAT_PERCENT, "share of time held");
}
