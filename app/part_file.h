/* part_file.h - the polygons of one surface from one host, in a file: PREFIX_surface.nodeN.part.
 *
 * A part file holds floats. A polygon is its number of vertices n, 3 to POLYGON_MAX, then n vertices of x y z
 * and normal. With -bynode the first float is n + PART_NODE * the node that made the polygon.
 */
#ifndef PART_FILE_H
#define PART_FILE_H
#include <stdio.h>
#include "polygon.h"

#define PART_NODE 16
#define PART_NAME_SIZE 512

typedef float part_vertex[6]; /* x y z and normal */

struct part_polygon {
    int n, node; /* node: that made it, or 0 */
    part_vertex v[POLYGON_MAX];
};

/* Writes the file's name to name[PART_NAME_SIZE]. */
void part_name(char *name, const char *prefix, int surface, int node);

/* Opens the part file of one host; fails if it cannot be written. */
FILE *part_begin(const char *prefix, int surface, int node);

/* Append polygons: each is the number that its first float will be, then its vertices. */
void part_write(FILE *part, const double *polygons, int doubles);

void part_end(FILE *part);

/* Append one polygon. */
void part_write_polygon(FILE *part, const struct part_polygon *p);

/* The bytes that a polygon takes in a file. */
long part_polygon_bytes(const struct part_polygon *p);

/* Reads the next polygon. Answers 0 at the end of the file. */
int part_read(FILE *part, struct part_polygon *p);

/* Reads the polygons of one surface from the parts of hosts 0, step, 2 step ... below nodes. part is NULL
 * before the first. */
struct part_reader {
    const char *prefix;
    int surface, nodes, step, node;
    FILE *part;
};

/* Answers 0 after the last polygon. Fails if a part file is missing. */
int part_next(struct part_reader *r, struct part_polygon *p);

/* Remove all part files of a reader. */
void part_remove(const struct part_reader *r);

#endif
