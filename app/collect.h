/* collect.h - a host's polygons: counted, put on one list per isovalue, written to part files or dropped. */
#ifndef COLLECT_H
#define COLLECT_H
#include "options.h"

struct collection {
    double polygons[ISOVALUES_MAX]; /* number for each isovalue */
    unsigned long long digest;      /* sum of the polygons' hashes: the order does not matter */
    double written_s;               /* spent writing part files */
};

/* Begins the collection of this node, whose number is in the names of its part files. Answers the collection,
 * which the functions below keep up to date. */
const struct collection *collect_begin(const struct options *o, int node);

/* Add one polygon. To be called with handlers masked, or from a handler. */
void collect_polygon(int iso, int n, const vertex *v);

/* Add packed polygons of one surface; collect_pack says how a polygon is packed. */
void collect_packed(int iso, const double *set, long doubles);

/* Pack one polygon: n, then its n vertices. Answers the doubles used, 1 + 6 n. */
int collect_pack(int n, const vertex *v, double *to);

/* Empty the lists and close the part files; no polygon may follow. */
void collect_end(void);

#endif
