/* shrink.h - makes a program on which two engines differ as small as it can be. */
#ifndef PROVE_SHRINK_H
#define PROVE_SHRINK_H
#include "trial.h"

/* p, on which a way of running it gives other results than the reference, becomes smaller, and still does,
 * and in the same result: fewer nodes, fewer operations, smaller numbers. */
void shrink(const struct place *place, struct program **p, const char *way);
#endif
