/* shrink.h - makes a program on which two engines differ as small as it can be. */
#ifndef PROVE_SHRINK_H
#define PROVE_SHRINK_H
#include "trial.h"

/* Makes p smaller - fewer nodes, fewer operations, smaller numbers - while the given way of running p differs
 * from the reference in the given result. */
void shrink(const struct place *place, struct program **p, const char *way);
#endif
