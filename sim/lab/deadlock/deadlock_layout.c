/* deadlock_layout.c - see deadlock_layout.h. */
#include "lab/deadlock/deadlock_layout.h"
#include <math.h>
#include "kernel/xalloc.h"

enum { MOST_ON_ELLIPSE = 10, COLUMNS = 3, ROW = DEADLOCK_BOX_HEIGHT + 46, MARGIN = 34 };

struct ellipse {
    uint32_t count;
    double rx, ry;
};

static struct ellipse ellipse_for(uint32_t count)
{
    const double widest = (CANVAS_WIDTH - DEADLOCK_BOX_WIDTH) / 2.0 - MARGIN;
    if (count <= 1)
        return (struct ellipse){count, 0, 0};
    if (count == 2)
        return (struct ellipse){count, 200, 0};
    return (struct ellipse){count, count <= 4 ? 270 : widest, count <= 4 ? 110 : 34.0 * count};
}

/* The first lies on top, or, of two, on the left; the others follow clockwise. */
static struct plot on_ellipse(const struct ellipse *e, uint32_t k)
{
    double turn = 2 * M_PI * k / e->count - (e->count == 2 ? M_PI : M_PI / 2);
    double x = CANVAS_WIDTH / 2.0 + e->rx * cos(turn), y = e->ry * (1 + sin(turn));
    return (struct plot){round(x - DEADLOCK_BOX_WIDTH / 2.0), round(DEADLOCK_HEAD + MARGIN + y),
                         DEADLOCK_BOX_WIDTH, DEADLOCK_BOX_HEIGHT};
}

/* The last row lies in the middle. */
static struct plot in_row(uint32_t k, uint32_t count, double top)
{
    uint32_t row = k / COLUMNS, left = count - row * COLUMNS, columns = left < COLUMNS ? left : COLUMNS;
    const double step = (CANVAS_WIDTH - 2 * 24) / (double)COLUMNS;
    double x = CANVAS_WIDTH / 2.0 + (k % COLUMNS - (columns - 1) / 2.0) * step;
    return (struct plot){round(x - DEADLOCK_BOX_WIDTH / 2.0), round(top + row * ROW), DEADLOCK_BOX_WIDTH,
                         DEADLOCK_BOX_HEIGHT};
}

struct deadlock_layout deadlock_layout_make(const struct deadlock_graph *g)
{
    uint32_t round_count = g->cycle_count || g->count > MOST_ON_ELLIPSE ? g->cycle_count : g->count;
    struct ellipse e = ellipse_for(round_count);
    struct deadlock_layout l = {.places = xcalloc(g->count ? g->count : 1, sizeof *l.places)};
    double top = DEADLOCK_HEAD + MARGIN + (round_count ? 2 * e.ry + ROW : 0);
    for (uint32_t k = 0; k < g->count; k++)
        l.places[k] =
            k < round_count ? on_ellipse(&e, k) : in_row(k - round_count, g->count - round_count, top);
    uint32_t rows = (g->count - round_count + COLUMNS - 1) / COLUMNS;
    l.height = top + rows * ROW + DEADLOCK_FOOT;
    return l;
}
