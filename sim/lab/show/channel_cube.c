/* channel_cube.c - the channels of a hypercube: a row a node, a column a dimension; then the ports. */
#include "lab/show/channel_cube.h"
#include <math.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

enum { LABEL_APART = 12 };

/* Rows are the addresses that are shown: nodes, I/O nodes, host. */
struct cube_table {
    const struct channel_map *map;
    uint32_t bin, rows, columns;
    uint32_t *address;  /* of a row */
    uint32_t *channels; /* [row][column]; none: topo.channels */
};

static uint32_t rows_of(const struct show *s)
{
    bool *shown = channel_map_shown(s);
    uint32_t rows = 0;
    for (uint32_t a = 0; a < s->trace->topo.addresses; a++)
        rows += shown[a];
    free(shown);
    return rows;
}

static double row_height(uint32_t rows)
{
    return show_row_height((int32_t)rows, 540, 1, 28);
}

double channel_cube_height(const struct show *s)
{
    uint32_t rows = rows_of(s);
    return 22 + rows * row_height(rows) + 60;
}

/* The column of a channel: its dimension; then in and out. */
static uint32_t column_of(const struct topo *topo, struct topo_channel c)
{
    return c.kind == TOPO_IN    ? topo->dimension
           : c.kind == TOPO_OUT ? topo->dimension + 1
                                : (uint32_t)__builtin_ctz(c.from ^ c.to);
}

static void list_rows(struct cube_table *t, uint32_t *row_of)
{
    for (uint32_t a = 0; a < t->map->show->trace->topo.addresses; a++) {
        row_of[a] = t->map->shown[a] ? t->rows : UINT32_MAX;
        if (t->map->shown[a])
            t->address[t->rows++] = a;
    }
}

static struct cube_table table_of(const struct channel_map *m, uint32_t bin)
{
    const struct topo *topo = &m->show->trace->topo;
    struct cube_table t = {.map = m, .bin = bin, .columns = topo->dimension + 2};
    uint32_t *row_of = xcalloc(topo->addresses, sizeof *row_of);
    t.address = xcalloc(topo->addresses, sizeof *t.address);
    list_rows(&t, row_of);
    t.channels = xcalloc((size_t)t.rows * t.columns, sizeof *t.channels);
    for (size_t i = 0; i < (size_t)t.rows * t.columns; i++)
        t.channels[i] = topo->channels;
    for (uint32_t c = 0; c < topo->channels; c++) {
        struct topo_channel channel = topo_channel(topo, c);
        if (row_of[channel.from] != UINT32_MAX)
            t.channels[row_of[channel.from] * t.columns + column_of(topo, channel)] = c;
    }
    free(row_of);
    return t;
}

static double share(const void *ctx, uint32_t column, uint32_t row)
{
    const struct cube_table *t = ctx;
    uint32_t channel = t->channels[row * t->columns + column];
    return channel < t->map->use.channels ? channel_use_share(&t->map->use, t->bin, channel) : 0;
}

static char *row_name(const struct topo *topo, uint32_t address)
{
    return address < topo->positions     ? xasprintf("%u", address)
           : topo_is_host(topo, address) ? xstrdup("host")
                                         : xasprintf("I/O %u", address - topo->positions);
}

static void draw_labels(const struct canvas *c, struct plot p, const struct cube_table *t)
{
    const struct topo *topo = &t->map->show->trace->topo;
    const struct text_style row = {10, INK, ANCHOR_RIGHT, false}, column = {10, INK, ANCHOR_MIDDLE, false};
    double h = p.h / t->rows, w = p.w / t->columns, wide = 0;
    uint32_t step = 1;
    while (step * h < LABEL_APART)
        step *= 2;
    for (uint32_t r = 0; r < t->rows; r += step) {
        char *text = row_name(topo, t->address[r]);
        canvas_line(c, p.x - 4, p.y + (r + 0.5) * h, p.x, p.y + (r + 0.5) * h, 1, INK);
        canvas_text(c, p.x - 7, p.y + (r + 0.5) * h + 3.5, row, text);
        wide = fmax(wide, canvas_text_width(c, row, text));
        free(text);
    }
    for (uint32_t i = 0; i < t->columns; i++) {
        char *text = i < topo->dimension ? xasprintf("%u", i) : xstrdup(i == topo->dimension ? "in" : "out");
        canvas_text(c, p.x + (i + 0.5) * w, p.y - 8, column, text);
        if (i)
            canvas_line(c, p.x + i * w, p.y, p.x + i * w, p.y + p.h, i == topo->dimension ? 1.5 : 0.5,
                        i == topo->dimension ? INK : PALE);
        free(text);
    }
    canvas_text_upward(c, p.x - wide - 15, p.y + p.h / 2, (struct text_style){11, INK, ANCHOR_MIDDLE, false},
                       "from node");
    canvas_text(c, p.x, p.y + p.h + 22,
                (struct text_style){11, INK, ANCHOR_LEFT, false}, /* wider than a small cube */
                "dimension of the channel; the ports into and out of the network");
}

void channel_cube_draw(const struct channel_map *m, const struct canvas *c, double y, uint32_t bin)
{
    struct cube_table t = table_of(m, bin);
    struct plot p = {LEFT, y + 22, fmin(t.columns * 90, 640), t.rows * row_height(t.rows)};
    heat_grid(c, p, &m->heat, t.columns, t.rows, row_height(t.rows) > 8 ? 1 : 0, share, &t);
    draw_labels(c, p, &t);
    canvas_frame(c, p);
    heat_bar(c, (struct plot){p.x + p.w + 50, p.y + 16, 14, fmin(p.h - 16, 300)}, &m->heat, HEAT_PERCENT,
             "share of time held");
    free(t.address);
    free(t.channels);
}
