/* layer.h - two slices of grid data, the subcubes between them, and their computing. */
#ifndef LAYER_H
#define LAYER_H
#include "options.h"

/* Rows of grid points of two neighbouring slices, from grid row `row` on. */
struct layer {
    const double *lower, *upper;
    int number; /* of the layer in the volume */
    int row;
};

/* Set up the fit's equations before a subcube, as far as policy.prepare asks for it. nth: the subcube's
 * number among those computed together, from 0 on. system consists of zeros before the first call. */
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

/* Greatest length of a chunk, in bytes. */
long chunk_bytes_max(const struct options *o);

/* Pack subcubes [first, first + count) of a layer; a grid point of several subcubes is packed once. Answers
 * the bytes. */
long chunk_pack(const struct grid *g, const struct layer *l, int first, int count, double *message);

/* Pack a chunk without subcubes: CHUNK_NO_MORE or CHUNK_DISCARD. Answers the bytes. */
long chunk_pack_word(enum chunk_kind kind, double *message);

/* The chunk in a message; its rows stay in the message. */
struct chunk chunk_unpack(const struct grid *g, const double *message);

#endif
