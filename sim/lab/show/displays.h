/* displays.h - the displays, by name: what each shows, and how it is drawn. They are those of ParaGraph (Heath &
 * Etheridge, Visualizing the Performance of Parallel Programs, IEEE Software 8(5), 1991). */
#ifndef LAB_SHOW_DISPLAYS_H
#define LAB_SHOW_DISPLAYS_H
#include "lab/show/canvas.h"
#include "lab/show/node_rows.h"

/* What to draw, and how. */
struct show {
    const struct trace *trace; /* trace.from < trace.to */
    struct node_rows rows;     /* at least one */
    bool by_bytes;             /* count bytes of messages, instead of messages */
    size_t most_lines;         /* messages of a space-time diagram */
    uint32_t frames;           /* of a film */
};

struct display {
    const char *name;                       /* "gantt" */
    const char *title;                      /* "Gantt chart" */
    const char *what;                       /* one sentence: what it shows */
    const char *look;                       /* one sentence: what to look for */
    double (*height)(const struct show *s); /* of the picture, in points */
    void (*draw)(const struct show *s, const struct canvas *c);
    bool film; /* not drawn by draw(): show_film() writes it (channel_film.h) */
};

extern const struct display DISPLAYS[];               /* the last one has no name */
const struct display *display_find(const char *name); /* NULL: there is none of that name */

enum {
    HEAD_HEIGHT = 84, /* of the head of a picture */
    LEFT = 84         /* of it, of a plot: room for the rows' labels */
};
/* Draws the head: the display's title; the program, machine, nodes and interval; and notes, malloc'd, which it
 * frees. */
void show_head(const struct show *s, const struct canvas *c, const char *title, char *notes);
/* Height of a row of a picture whose rows shall have `all` points together; between least and most. */
double show_row_height(int32_t rows, double all, double least, double most);
#endif
