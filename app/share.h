/* share.h - the rules by which work and nodes are divided. Arithmetic only: no messages. */
#ifndef SHARE_H
#define SHARE_H

/* The layers of one group: first, first + 1, ... */
struct span {
    int first, layers;
};

/* n things in a row are dealt in equal shares, what is left over one each to the first groups; of them
 * `layers` are layers, from the first on. n = layers deals layers; n = layers + 1 deals slices, of which each
 * stands for the layer above it, so that the last group has one layer less than slices. */
struct span share_layers(int n, int layers, int groups, int group);

/* The subcubes of the current layer that are in nobody's hands: [head, tail). Chunks leave from the head in
 * whole rows, the host helps itself from the tail. */
struct pool {
    int head, tail, total, row; /* row: subcubes in a row */
};

void pool_fill(struct pool *p, int rows, int row);
int pool_left(const struct pool *p);

/* Size of the next chunk for a group of `nodes`: 1/(k nodes) of the layer first, left/nodes when that is
 * less, rounded up to whole rows, at least min_rows of them, at most what is left. Takes it from the pool;
 * *first is its first subcube. */
int pool_chunk(struct pool *p, double k, int nodes, int min_rows, int *first);

/* The most subcubes that pool_chunk takes from a layer of rows x row of them, whatever was taken before. Who
 * hands out chunks has a slave, so that a group has two nodes at least. */
int pool_chunk_max(int rows, int row, double k, int min_rows);

/* The host takes up to gran subcubes from the tail, but leaves keep of them. Answers how many; *first: the
 * first. */
int pool_help(struct pool *p, int gran, int keep, int *first);

/* Deal n nodes to `places` in proportion to their weights (>= 0), by largest remainder; of equal remainders
 * the first place wins. With no weight at all nobody gets any. */
void share_nodes(int n, int places, const double *weight, int *got);

#endif
