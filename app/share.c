/* share.c - the rules of share.h. */
#include "share.h"

struct span share_layers(int n, int layers, int groups, int group)
{
    int each = n / groups, extra = n % groups;
    struct span s;

    s.first = group * each + (group < extra ? group : extra);
    s.layers = each + (group < extra);
    if (s.first + s.layers > layers)
        s.layers = layers - s.first;
    if (s.layers < 0)
        s.layers = 0;
    return s;
}

void pool_fill(struct pool *p, int rows, int row)
{
    p->head = 0;
    p->tail = p->total = rows * row;
    p->row = row;
}

int pool_left(const struct pool *p)
{
    return p->tail - p->head;
}

int pool_chunk(struct pool *p, double k, int nodes, int min_rows, int *first)
{
    int left = pool_left(p), rows;
    double want = p->total / (k * nodes), even = (double)left / nodes;

    if (even < want)
        want = even;
    rows = (int)(want / p->row);
    if (rows * p->row < want)
        rows++;
    if (rows < min_rows)
        rows = min_rows;
    *first = p->head;
    p->head = rows <= left / p->row ? p->head + rows * p->row : p->tail;
    return p->head - *first;
}

int pool_chunk_max(int rows, int row, double k, int min_rows)
{
    struct pool full;
    int first;

    pool_fill(&full, rows, row);
    return pool_chunk(&full, k, 2, min_rows, &first);
}

int pool_help(struct pool *p, int gran, int keep, int *first)
{
    int n = pool_left(p) - keep;

    if (n > gran)
        n = gran;
    if (n < 0)
        n = 0;
    p->tail -= n;
    *first = p->tail;
    return n;
}

void share_nodes(int n, int places, const double *weight, int *got)
{
    double sum = 0, rest, best_rest;
    int i, best, left = n;

    for (i = 0; i < places; i++) {
        sum += weight[i];
        got[i] = 0;
    }
    if (sum <= 0)
        return;
    for (i = 0; i < places; i++) {
        got[i] = (int)(n * weight[i] / sum);
        left -= got[i];
    }
    /* a place that got one of the rest has a remainder below 0 and gets no second */
    for (; left > 0; left--) {
        for (best = -1, best_rest = 0, i = 0; i < places; i++) {
            rest = n * weight[i] / sum - got[i];
            if (weight[i] > 0 && (best < 0 || rest > best_rest)) {
                best = i;
                best_rest = rest;
            }
        }
        got[best]++;
    }
}
