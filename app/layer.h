/* layer.h - two slices of grid data with the subcubes between them, and computing these. */
#ifndef LAYER_H
#define LAYER_H
#include "options.h"

/* Rows of grid points of two neighbouring slices, from grid row `row` on. */
struct layer {
    const double *lower, *upper;
    int number; /* of the layer in the volume */
    int row;
};

/* Prepare what the subcubes that are computed together have in common. Called before each of them, whose
 * number among them is nth, from 0 on; what this does is the policy's. system is of zeros at first. */
void layer_prepare(const struct options *o, struct fit_system *system, int nth);

/* Find the polygons of subcube `cell` (row * nx + column) of a layer. */
void layer_cell(const struct options *o, struct fit_system *system, const struct layer *l, int cell,
                polygon_fn *out);

/* A chunk is a message of doubles: this header, the lower slice's rows, the upper slice's rows. */
enum chunk_kind { CHUNK_WORK, CHUNK_NO_MORE, CHUNK_DISCARD };

struct chunk {
    enum chunk_kind kind;
    int first, count; /* subcubes [first, first + count) of the layer, whole rows but for the last */
    struct layer layer;
};

/* Greatest length of a chunk. */
long chunk_bytes_max(const struct options *o);

/* Pack subcubes [first, first + count) of a layer; the grid points that they share go in once. Answers the
 * bytes. */
long chunk_pack(const struct grid *g, const struct layer *l, int first, int count, double *message);

/* Pack a message without subcubes. */
long chunk_pack_word(enum chunk_kind kind, double *message);

/* Look at a message; the chunk's rows stay where they are. */
struct chunk chunk_unpack(const struct grid *g, const double *message);

#endif
