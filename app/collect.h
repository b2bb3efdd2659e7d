/* collect.h - a host's polygons: counted, put on one list per isovalue, written to part files or dropped. */
#ifndef COLLECT_H
#define COLLECT_H
#include "options.h"

struct collection {
    double polygons[ISOVALUES_MAX]; /* number for each isovalue */
    unsigned long long digest;      /* sum of the polygons' hashes: the order does not matter */
};

/* node: names the part files. Answers the collection, which collect_* keep up to date. */
const struct collection *collect_begin(const struct options *o, int node);

/* Take one polygon. Call it with handlers held back, or from a handler. */
void collect_polygon(int iso, int n, const vertex *v);

/* Take a set of packed polygons of one surface: each is n, and n vertices. */
void collect_packed(int iso, const double *set, long doubles);

/* Pack one polygon in that form; answers the doubles used, 1 + 6 n. */
int collect_pack(int n, const vertex *v, double *to);

/* Empty the lists; no polygons follow. */
void collect_end(void);

#endif
