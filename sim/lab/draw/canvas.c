/* canvas.c - see canvas.h. */
#include "lab/draw/canvas.h"
#include <fontconfig/fontconfig.h>
#include <math.h>

const struct colour INK = {0.13, 0.13, 0.13}, GREY = {0.38, 0.38, 0.38}, PALE = {0.85, 0.85, 0.85};

static void set_font(const struct canvas *c, struct text_style style)
{
    cairo_select_font_face(c->cr, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(c->cr, style.size);
}

double canvas_text_width(const struct canvas *c, struct text_style style, const char *text)
{
    cairo_text_extents_t e;
    set_font(c, style);
    cairo_text_extents(c->cr, text, &e);
    return e.x_advance;
}

static void show_text(const struct canvas *c, double x, double y, struct text_style style, const char *text)
{
    static const double SHARES[] = {[ANCHOR_LEFT] = 0, [ANCHOR_MIDDLE] = 0.5, [ANCHOR_RIGHT] = 1};
    double width = canvas_text_width(c, style, text);
    canvas_colour(c, style.colour);
    cairo_move_to(c->cr, x - width * SHARES[style.anchor], y);
    cairo_show_text(c->cr, text);
    cairo_new_path(c->cr); /* the point behind the text */
}

void canvas_text(const struct canvas *c, double x, double y, struct text_style style, const char *text)
{
    show_text(c, x, y, style, text);
}

void canvas_text_clear(const struct canvas *c, double x, double y, struct text_style style, const char *text)
{
    double width = canvas_text_width(c, style, text);
    double left = x - (style.anchor == ANCHOR_LEFT ? 0 : style.anchor == ANCHOR_MIDDLE ? width / 2 : width);
    cairo_set_source_rgba(c->cr, 1, 1, 1, 0.75);
    cairo_rectangle(c->cr, left - 2, y - style.size * 0.85, width + 4, style.size * 1.1);
    cairo_fill(c->cr);
    show_text(c, x, y, style, text);
}

void canvas_text_upward(const struct canvas *c, double x, double y, struct text_style style, const char *text)
{
    style.anchor = ANCHOR_MIDDLE;
    cairo_save(c->cr);
    cairo_translate(c->cr, x, y);
    cairo_rotate(c->cr, -M_PI / 2);
    show_text(c, 0, 0, style, text);
    cairo_restore(c->cr);
}

void canvas_colour(const struct canvas *c, struct colour colour)
{
    cairo_set_source_rgb(c->cr, colour.r, colour.g, colour.b);
}

void canvas_fill(const struct canvas *c, struct plot area, struct colour colour)
{
    canvas_colour(c, colour);
    cairo_rectangle(c->cr, area.x, area.y, area.w, area.h);
    cairo_fill(c->cr);
}

void canvas_line(const struct canvas *c, double x1, double y1, double x2, double y2, double width,
                 struct colour colour)
{
    canvas_colour(c, colour);
    cairo_set_line_width(c->cr, width);
    cairo_move_to(c->cr, x1, y1);
    cairo_line_to(c->cr, x2, y2);
    cairo_stroke(c->cr);
}

void canvas_frame(const struct canvas *c, struct plot area)
{
    canvas_colour(c, INK);
    cairo_set_line_width(c->cr, 1);
    cairo_rectangle(c->cr, area.x - 0.5, area.y - 0.5, area.w + 1, area.h + 1);
    cairo_stroke(c->cr);
}

double canvas_round(const struct canvas *c, double length)
{
    return c->vector ? round(length * 4) / 4 : length;
}

void canvas_forget_fonts(void)
{
    cairo_debug_reset_static_data();
    FcFini();
}
