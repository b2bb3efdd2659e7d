/* ply.h - surfaces as PLY files.
 *
 * Each host writes the polygons that it receives to part files, one per isovalue. At the end node 0 joins the
 * part files. A PLY file appears under its name only when it is complete.
 */
#ifndef PLY_H
#define PLY_H
#include "options.h"

/* What a file holds. loose: vertices that stand for one corner of one polygon, although other corners may be
 * at their positions; room: vertices of two layers that there was memory for. */
struct ply_file {
    char name[512];
    long polygons, vertices, loose, room;
};

/* Join the parts of hosts 0, step, 2 step ... below nodes to PREFIX_surface.ply, and remove the parts. */
struct ply_file ply_join(const struct options *o, int surface, int nodes, int step);

#endif
