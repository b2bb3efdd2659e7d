/* heat.c - see heat.h. */
#include "lab/draw/heat.h"
#include <math.h>
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lab/draw/axes.h"

enum {
    FAR_APART = 50,    /* times as much: then the scale is logarithmic */
    LABELS_APART = 12, /* points */
    MOST_STEPS = 5
};

struct heat heat_linear(double most)
{
    return (struct heat){.most = axis_end(most)};
}

struct heat heat_scale(double least, double most)
{
    if (!(most > 0))
        return heat_linear(0);
    if (most / least < FAR_APART)
        return heat_linear(most);
    return (struct heat){.least = pow(10, floor(log10(least))), .most = axis_end(most), .logarithmic = true};
}

struct heat heat_given(double end, bool logarithmic)
{
    return (struct heat){
        .least = logarithmic ? 1 : 0, .most = end, .logarithmic = logarithmic, .given = true};
}

int heat_level(const struct heat *h, double amount)
{
    if (!(amount > 0))
        return HEAT_NONE;
    double at = h->logarithmic ? log(amount / h->least) / log(h->most / h->least)
                               : (amount - h->least) / (h->most - h->least);
    int level = (int)(at * PALETTE_LEVELS);
    return level < 0 ? 0 : level >= PALETTE_LEVELS ? PALETTE_LEVELS - 1 : level;
}

/* Adds the shapes of a level in a row to the path. */
static void add_runs(const struct canvas *c, struct plot row, const signed char *levels, uint32_t columns,
                     int level)
{
    double width = row.w / columns;
    for (uint32_t i = 0; i < columns; i++) {
        uint32_t first = i;
        while (i < columns && levels[i] == level)
            i++;
        if (i == first)
            continue;
        double x = canvas_round(c, row.x + first * width), end = canvas_round(c, row.x + i * width);
        cairo_rectangle(c->cr, x, row.y, end - x, row.h);
    }
}

void heat_grid(const struct canvas *c, struct plot p, const struct heat *h, uint32_t columns, uint32_t rows,
               double gap, heat_cell *cell, const void *ctx)
{
    signed char *levels = xcalloc((size_t)columns * rows, 1);
    double height = p.h / rows;
    for (uint32_t r = 0; r < rows; r++)
        for (uint32_t i = 0; i < columns; i++)
            levels[(size_t)r * columns + i] = (signed char)heat_level(h, cell(ctx, i, r));
    for (int level = 0; level < PALETTE_LEVELS; level++) {
        for (uint32_t r = 0; r < rows; r++) {
            double y = canvas_round(c, p.y + r * height), end = canvas_round(c, p.y + (r + 1) * height - gap);
            add_runs(c, (struct plot){p.x, y, p.w, end - y}, levels + (size_t)r * columns, columns, level);
        }
        canvas_colour(c, palette_level(level));
        cairo_fill(c->cr);
    }
    free(levels);
}

char *heat_label(const struct heat *h, double amount, enum heat_unit unit)
{
    char *number =
        unit == HEAT_PERCENT ? axis_percent_text(amount) : axis_number_text(amount, unit == HEAT_BYTES);
    if (!h->given || amount < h->most)
        return number;
    char *label = xasprintf("%s or more", number);
    free(number);
    return label;
}

static void tick(const struct canvas *c, struct plot p, const struct heat *h, double amount,
                 enum heat_unit unit)
{
    const struct text_style style = {10, INK, ANCHOR_LEFT, false};
    double at = h->logarithmic ? log(amount / h->least) / log(h->most / h->least)
                               : (amount - h->least) / (h->most - h->least);
    double y = p.y + p.h * (1 - at);
    char *text = heat_label(h, amount, unit);
    canvas_line(c, p.x + 14, y, p.x + 18, y, 1, INK);
    canvas_text(c, p.x + 21, y + 3.5, style, text);
    free(text);
}

void heat_bar(const struct canvas *c, struct plot p, const struct heat *h, enum heat_unit unit,
              const char *title)
{
    for (int level = 0; level < PALETTE_LEVELS; level++) {
        double from = p.y + p.h * (PALETTE_LEVELS - 1 - level) / PALETTE_LEVELS;
        canvas_fill(c, (struct plot){p.x, from, 14, p.h / PALETTE_LEVELS + 0.2}, palette_level(level));
    }
    canvas_frame(c, (struct plot){p.x, p.y, 14, p.h});
    canvas_text(c, p.x, p.y - 10, (struct text_style){10.5, INK, ANCHOR_LEFT, false}, title);
    int steps = (int)fmin(MOST_STEPS, fmax(1, p.h / LABELS_APART));
    double step = unit == HEAT_PERCENT ? axis_step(h->most, steps) : axis_count_step(h->most, steps);
    if (h->given || (h->logarithmic && h->most > 2 * pow(10, floor(log10(h->most)))))
        tick(c, p, h, h->most, unit);
    double last = !h->given ? h->most * (1 + 1e-9) : h->logarithmic ? h->most / 2 : h->most - step / 2;
    for (double v = h->logarithmic ? h->least : 0; v <= last; v = h->logarithmic ? v * 10 : v + step)
        tick(c, p, h, v, unit);
}
