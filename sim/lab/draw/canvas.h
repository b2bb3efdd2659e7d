/* canvas.h - what pictures are drawn on, by libcairo: an SVG, or pixels, two a point each way. Lengths are
 * points: a picture is CANVAS_WIDTH of them wide. */
#ifndef LAB_DRAW_CANVAS_H
#define LAB_DRAW_CANVAS_H
#include <cairo/cairo.h>
#include <stdbool.h>

enum { CANVAS_WIDTH = 960, CANVAS_PIXELS = 2 }; /* pixels a point */

struct canvas {
    cairo_t *cr;
    bool vector; /* an SVG: shapes cost bytes */
    double width, height;
};

struct colour {
    double r, g, b; /* 0 to 1, sRGB */
};
#define COLOUR(hex)                                                                                          \
    ((struct colour){((hex) >> 16 & 255) / 255.0, ((hex) >> 8 & 255) / 255.0, ((hex)&255) / 255.0})

/* A rectangle: x and y are its upper left corner. */
struct plot {
    double x, y, w, h;
};

/* Where a text's point lies in it: y is always its baseline. */
enum anchor { ANCHOR_LEFT, ANCHOR_MIDDLE, ANCHOR_RIGHT };

struct text_style {
    double size;
    struct colour colour;
    enum anchor anchor;
    bool bold;
};
extern const struct colour INK, GREY, PALE; /* texts and frames; lesser texts; grid lines */

void canvas_text(const struct canvas *c, double x, double y, struct text_style style, const char *text);
/* The same, on a white ground. */
void canvas_text_clear(const struct canvas *c, double x, double y, struct text_style style, const char *text);
/* The same, read from below to above, around its middle. */
void canvas_text_upward(const struct canvas *c, double x, double y, struct text_style style,
                        const char *text);
double canvas_text_width(const struct canvas *c, struct text_style style, const char *text);

void canvas_colour(const struct canvas *c, struct colour colour);
void canvas_fill(const struct canvas *c, struct plot area, struct colour colour);
void canvas_line(const struct canvas *c, double x1, double y1, double x2, double y2, double width,
                 struct colour colour);
void canvas_frame(const struct canvas *c, struct plot area);
/* The length rounded so that an SVG writes it with few digits. */
double canvas_round(const struct canvas *c, double length);
/* Frees the fonts that libcairo keeps. To be called when no canvas will follow, so that checkers of memory
 * find none left. */
void canvas_forget_fonts(void);
#endif
