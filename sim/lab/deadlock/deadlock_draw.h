/* deadlock_draw.h - pictures of a wait-for graph. They can be told without colours: the cycle is thick, a
 * wait that any of several nodes could end is dashed, nodes that do not wait are grey. */
#ifndef LAB_DEADLOCK_DEADLOCK_DRAW_H
#define LAB_DEADLOCK_DEADLOCK_DRAW_H
#include "lab/deadlock/deadlock_graph.h"
#include "lab/draw/picture_file.h"
#include "nx_api/waitfor/waitfor.h"

/* Of an analysed w. False with *error, malloc'd, which names the file. kind: PNG or SVG. */
bool deadlock_draw_file(const struct waitfor *w, const char *path, enum picture_kind kind, char **error);
/* The picture as the text of an SVG, malloc'd. */
char *deadlock_draw_svg(const struct waitfor *w);
/* The sentence above the picture, malloc'd. It names a knot only where the report does: where no node has a
 * reason of its own. */
char *deadlock_draw_summary(const struct waitfor *w);
/* The sentence below the picture, malloc'd: of each sign that the picture has, and of no other. */
char *deadlock_draw_legend(const struct deadlock_graph *g);
#endif
