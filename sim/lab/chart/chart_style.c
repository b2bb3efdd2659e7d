/* chart_style.c - see chart_style.h. */
#include "lab/chart/chart_style.h"

#include <math.h>

#define COUNT(list) (sizeof(list) / sizeof *(list))

/* In this order, neighbours differ in lightness, too. */
static const char *const COLOURS[] = {"#000000", "#e69f00", "#0072b2", "#cc79a7",
                                      "#009e73", "#56b4e9", "#d55e00"};

static const char *const DASHES[] = {"solid",          "(14,5)", "(5,4)", "(14,4,4,4)",
                                     "(14,4,4,4,4,4)", "(24,6)", "(9,3)"};

/* Circle, square, triangle, diamond, turned triangle; the same, hollow; pentagons, near to circles. */
static const int MARKERS[] = {7, 5, 9, 13, 11, 6, 4, 8, 12, 10, 15, 14};

/* From dark to light; where x is from 0 to 1. */
static void ramp(double x, char colour[8])
{
    static const double stops[][3] = {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}};
    double at = x * (COUNT(stops) - 1);
    size_t from = x < 1 ? (size_t)at : COUNT(stops) - 2;
    unsigned mixed[3];
    for (int i = 0; i < 3; i++)
        mixed[i] =
            (unsigned)lround(stops[from][i] + (at - (double)from) * (stops[from + 1][i] - stops[from][i]));
    snprintf(colour, 8, "#%02x%02x%02x", mixed[0] & 255, mixed[1] & 255, mixed[2] & 255);
}

struct line_style style_of(size_t line, size_t lines, bool ordered)
{
    struct line_style s = {"", DASHES[line % COUNT(DASHES)], MARKERS[line % COUNT(MARKERS)]};
    if (ordered && lines > 2)
        ramp((double)line / (double)(lines - 1), s.colour);
    else
        snprintf(s.colour, sizeof s.colour, "%s", COLOURS[line % COUNT(COLOURS)]);
    return s;
}

int style_hollow(int marker)
{
    /* gnuplot numbers each filled marker after its hollow form */
    return marker >= 5 && marker <= 15 && marker % 2 ? marker - 1 : marker;
}

void style_terminal(FILE *out, bool svg, unsigned width, unsigned height)
{
    if (svg)
        fprintf(out, "set terminal svg noenhanced size %u,%u font 'Sans,12' background rgb 'white'\n", width,
                height);
    else
        fprintf(out,
                "set terminal pngcairo noenhanced size %u,%u font 'Sans,10' fontscale 2 linewidth 2 "
                "pointscale 2 background rgb 'white'\n",
                2 * width, 2 * height);
}
