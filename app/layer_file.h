/* layer_file.h - the polygons of one surface in a file of their own, layer after layer of the volume.
 *
 * A layer's polygons share vertices with each other and with the neighbouring layers' polygons, and with no
 * others: whoever reads them in this order needs memory for a layer only. Polygons whose vertices are partly
 * equal as floats are cut there, and dropped where less than three vertices are left.
 */
#ifndef LAYER_FILE_H
#define LAYER_FILE_H
#include "grid.h"
#include "part_file.h"

struct layer_file {
    const struct grid *grid;
    FILE *file;
    char name[PART_NAME_SIZE];
    long polygons;
    long *corners; /* of each layer's polygons, added up */
    long *begin;   /* of each layer in the file, and the end of the last */
    long left;     /* bytes of the layer being read */
};

/* Sorts the polygons that r will read into PREFIX_surface.layers. Takes 24 bytes of memory for a layer.
 * If there is memory for all polygons of a layer, too, their order does not depend on the order in
 * which they are read. */
struct layer_file *layer_file_begin(const struct grid *g, const struct part_reader *r);

/* Read a layer's polygons from the first on. */
void layer_file_open(struct layer_file *f, int layer);

/* Answers 0 after the layer's last polygon. */
int layer_file_next(struct layer_file *f, struct part_polygon *p);

/* z of the vertices on the lower side of a layer. */
float layer_floor(const struct grid *g, int layer);

/* Removes the file. */
void layer_file_end(struct layer_file *f);

#endif
