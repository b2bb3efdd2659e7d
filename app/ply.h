/* ply.h - surfaces as PLY files.
 *
 * Each host writes the polygons that it receives to part files, one per isovalue. At the end node 0 joins the
 * part files. A PLY file appears under its name only when it is complete.
 */
#ifndef PLY_H
#define PLY_H
#include <stdio.h>

/* Opens the part file PREFIX_surface.nodeN.part of one host; fails if it cannot be written. */
FILE *ply_part_begin(const char *prefix, int surface, int node);

/* Append polygons: each is its number of vertices n, then n vertices of 6 doubles. */
void ply_part_write(FILE *part, const double *polygons, int doubles);

void ply_part_end(FILE *part);

/* Join the parts of hosts 0, step, 2 step ... below nodes to PREFIX_surface.ply, and remove the parts. */
void ply_join(const char *prefix, int surface, int nodes, int step);

#endif
