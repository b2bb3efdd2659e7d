/* displays.h - the displays, by name: what each shows, and how it is drawn. They are those of ParaGraph
 * (Heath & Etheridge, Visualizing the Performance of Parallel Programs, IEEE Software 8(5), 1991). */
#ifndef LAB_SHOW_DISPLAYS_H
#define LAB_SHOW_DISPLAYS_H
#include "lab/draw/picture_head.h"

struct display {
    const char *name;                       /* "gantt" */
    const char *what;                       /* one sentence: what it shows */
    const char *look;                       /* one sentence: what to look for */
    double (*height)(const struct show *s); /* of the picture, in points */
    void (*draw)(const struct show *s, const struct canvas *c);
    bool compares; /* --than: two runs are drawn with one scale of time */
    bool film;     /* not drawn by draw(): channel_film_write() writes it */
};

extern const struct display DISPLAYS[];               /* the last one has no name */
const struct display *display_find(const char *name); /* NULL: there is none of that name */
#endif
