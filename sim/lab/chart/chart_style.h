/* chart_style.h - the looks of pictures: colours, markers and dashes of lines, one width for all, the size of
 * PNGs. Lines stay apart in grey print (by marker and dashes) and for colour-blind eyes (Okabe and Ito's
 * colours; for ordered lines a part of viridis, from dark to light). */
#ifndef LAB_CHART_CHART_STYLE_H
#define LAB_CHART_CHART_STYLE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#define CHART_WIDTH "lw 1.5" /* of every line of a picture */
#define CHART_IDEAL "with lines " CHART_WIDTH " dt (2,4) lc rgb '#707070'"
#define CHART_GRID "lt 1 lw 0.6 lc rgb '#d8d8d8'"

struct line_style {
    char colour[8];   /* "#rrggbb" */
    const char *dash; /* gnuplot's dashtype */
    int marker;       /* gnuplot's pointtype */
};

/* The style of a line. ordered: the lines stand for numbers in order. Of 84 lines no two have the same marker
 * and colour. */
struct line_style style_of(size_t line, size_t lines, bool ordered);
/* The hollow form of a marker; a marker that has none is its own. */
int style_hollow(int marker);

/* Sets gnuplot's terminal for an SVG, or for a PNG of twice that many pixels. */
void style_terminal(FILE *out, bool svg, unsigned width, unsigned height);
#endif
