/* surfaces.h - what becomes of the surfaces after the work: their files, and what is printed of them. */
#ifndef SURFACES_H
#define SURFACES_H
#include "options.h"

/* Called by all nodes, after report(). With -ply node 0 joins the part files; it prints the names of all
 * files that were written, how long that took, and to standard error why a surface is empty. */
void surfaces_end(const struct options *o, int is_host, int group_size);

#endif
