/* picture_head.h - what a display is asked to draw, and the head that all its pictures have. */
#ifndef LAB_DRAW_PICTURE_HEAD_H
#define LAB_DRAW_PICTURE_HEAD_H
#include "lab/draw/canvas.h"
#include "lab/draw/node_rows.h"

/* What to draw, and how. */
struct show {
    const struct trace *trace; /* from < to, which may be behind the run's end */
    const char *label;         /* which of two runs; NULL: there is one */
    struct node_rows rows;     /* at least one */
    bool by_bytes;             /* count bytes of messages, instead of messages */
    size_t most_lines;         /* messages of a space-time diagram; 0: as many as leave it readable */
    bool densest;              /* a space-time diagram of the interval with the most messages */
    double most_amount;        /* at which a matrix's scale ends; 0: at the most that a cell has */
    double most_share;         /* at which a channel map's scale ends; 0: at the busiest channel's, or 10 % */
    uint32_t frames;           /* of a film */
};

enum {
    HEAD_HEIGHT = 84, /* of the head of a picture */
    HEAD_LEFT = 24,   /* left of the head's texts */
    LEFT = 84         /* of it, of a plot: room for the rows' labels */
};
/* Draws the head: the display's title; the program, machine, nodes and interval; and notes, malloc'd,
 * which it frees. */
void show_head(const struct show *s, const struct canvas *c, const char *title, char *notes);
/* Height of a row of a picture whose rows shall have `all` points together; between least and most. */
double show_row_height(int32_t rows, double all, double least, double most);
#endif
