/* node_rows.h - the rows of a picture: a node each, or, of many nodes, a class each: neighbouring numbers,
 * a power of two of them. The host is a row of its own, and so are a few nodes that serve the others. */
#ifndef LAB_DRAW_NODE_ROWS_H
#define LAB_DRAW_NODE_ROWS_H
#include "lab/trace/trace_model.h"

enum {
    NODE_ROWS_SINGLE = 128, /* so many nodes have a row each */
    NODE_ROWS_CLASSES = 64, /* of more nodes: so many classes at most */
    NODE_ROWS_APART = 16    /* and so many hosts at most, each in a row of its own beside them */
};

struct node_rows {
    int32_t nodes; /* in rows, all of them */
    int32_t count; /* rows */
    int32_t per;   /* nodes a row; the last row may have fewer, and one beside a host; a host's has one */
    int32_t apart; /* rows of nodes that serve the others, where rows are of several nodes */
    bool host;     /* the last row is the host's */
    int32_t *row;  /* of each of trace.nodes; TRACE_NONE: not in the picture */
    struct node_class {
        int32_t first, last, size; /* indexes into trace.nodes; last is in the class */
        bool apart;                /* one node, which serves the others */
    } * classes;                   /* one a row */
    double *edge; /* where each row begins, and the last one ends, of a height of 1; NULL: all are as high */
};

/* The rows of the nodes that are traced (and selected: trace_load()), and that a program used. Freed by
 * node_rows_free(). */
struct node_rows node_rows_make(const struct trace *t);
/* As many rows as nodes. */
struct node_rows node_rows_single(const struct trace *t);
/* Makes the rows of hosts so many times as high as the others. Hosts serve the other nodes: the machine's
 * host, and nodes with a row each that send and receive more than twice as many messages as the mean; not if
 * they are more than a quarter. Returns how high all rows are together, in rows. */
double node_rows_heighten(struct node_rows *r, const struct trace *t, double times);
static inline double node_rows_edge(const struct node_rows *r, int32_t row)
{
    return r->edge ? r->edge[row] : (double)row / r->count;
}
void node_rows_free(struct node_rows *r);
/* "3", "8-15", "host"; "10240..." where numbers are long: a malloc'd text. */
char *node_rows_label(const struct node_rows *r, const struct trace *t, int32_t row);
/* "16 nodes", "512 nodes in 64 rows of 8", "128 nodes and the host in ...": malloc'd. what: "rows",
 * "spokes". */
char *node_rows_text(const struct node_rows *r, const char *what);
#endif
