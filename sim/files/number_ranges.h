/* number_ranges.h - numbers of nodes as text. */
#ifndef FILES_NUMBER_RANGES_H
#define FILES_NUMBER_RANGES_H
#include <stdint.h>
#include <stdio.h>

/* Prints "node 3", "nodes 1-5, 7", or "nodes 2, 4, ..., 510": count numbers, in ascending order; of many
 * ranges the first ones. */
void number_ranges_print_nodes(FILE *f, const uint32_t *nodes, uint32_t count);
#endif
