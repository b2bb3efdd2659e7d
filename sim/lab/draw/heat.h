/* heat.h - amounts as colours: cells of a grid, with the bar that says which colour is how much. */
#ifndef LAB_DRAW_HEAT_H
#define LAB_DRAW_HEAT_H
#include <stdint.h>
#include "lab/draw/canvas.h"
#include "lab/draw/palette.h"

enum { HEAT_NONE = -1 }; /* the level of 0: nothing is drawn */

struct heat {
    double least, most; /* of the scale; amounts outside have its end's colour */
    bool logarithmic;   /* least > 0 */
    bool given;         /* the end is not that of the amounts: its label says "or more" */
};

/* The scale of amounts from 0 to most, most rounded up. */
struct heat heat_linear(double most);
/* The scale from the least amount above 0 to the most: logarithmic if they are far apart. */
struct heat heat_scale(double least, double most);
/* The scale from 0 to a given end, or logarithmic from 1: the same for pictures of several runs. */
struct heat heat_given(double end, bool logarithmic);
int heat_level(const struct heat *h, double amount);

/* The amount of a cell. */
typedef double heat_cell(const void *ctx, uint32_t column, uint32_t row);
/* Draws all cells, columns x rows of one size; neighbours of one level in a row are one shape. gap: points
 * left free between rows. */
void heat_grid(const struct canvas *c, struct plot p, const struct heat *h, uint32_t columns, uint32_t rows,
               double gap, heat_cell *cell, const void *ctx);

enum heat_unit { HEAT_NUMBER, HEAT_BYTES, HEAT_PERCENT };
/* The bar, upright, 14 points wide, with its scale at the right and its title above. */
void heat_bar(const struct canvas *c, struct plot p, const struct heat *h, enum heat_unit unit,
              const char *title);
/* An amount beside the bar: "12 %", "3.5 kB", "17"; or "17 or more" at the end of a given scale. malloc'd. */
char *heat_label(const struct heat *h, double amount, enum heat_unit unit);
#endif
