/* share.h - the rules by which work and nodes are divided. Arithmetic only: no messages. */
#ifndef SHARE_H
#define SHARE_H

/* The layers of one group: first, first + 1, ... */
struct span {
    int first, layers;
};

/* The layers of a group when n things in a row are dealt in equal shares; the first groups get one each of
 * the remainder. The first `layers` things are layers. n = layers deals layers. n = layers + 1 deals slices,
 * each of which stands for the layer above it, so that the last group has one layer less than slices. */
struct span share_layers(int n, int layers, int groups, int group);

/* The subcubes of the open layer that no node has yet: [head, tail). Chunks are taken from the head in whole
 * rows, the host's own subcubes from the tail. */
struct pool {
    int head, tail, total, row; /* row: subcubes in a row */
};

void pool_fill(struct pool *p, int rows, int row);
int pool_left(const struct pool *p);

/* Takes the next chunk from the pool, for a group of `nodes` nodes. Answers its subcubes; *first is the first
 * of them. The chunk is the smaller of 1/(k nodes) of the layer and 1/nodes of what is left, rounded up to
 * whole rows; at least min_rows rows, at most what is left. */
int pool_chunk(struct pool *p, double k, int nodes, int min_rows, int *first);

/* The most subcubes that pool_chunk takes from a layer of rows x row subcubes, whatever was taken before. A
 * host that hands out chunks has a slave, so that its group has two nodes at least. */
int pool_chunk_max(int rows, int row, double k, int min_rows);

/* Takes up to gran subcubes from the tail, but leaves `keep`. Answers how many; *first is the first of
 * them. */
int pool_help(struct pool *p, int gran, int keep, int *first);

/* Deal n nodes to `places` places in proportion to their weights (>= 0), by largest remainder; of equal
 * remainders the first place wins. If all weights are 0, no place gets a node. */
void share_nodes(int n, int places, const double *weight, int *got);

#endif
