/* shape.h - the shape of the machine. */
#ifndef CALLS_SHAPE_H
#define CALLS_SHAPE_H

struct node;

/* The dimension of the smallest cube that holds all nodes. */
long nx_dimension(const struct node *n);

#endif
