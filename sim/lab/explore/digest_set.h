/* digest_set.h - a set of digests. */
#ifndef LAB_EXPLORE_DIGEST_SET_H
#define LAB_EXPLORE_DIGEST_SET_H
#include "lab/jobs/digest.h"

/* All 0: empty. */
struct digest_set {
    struct digest *slot; /* a power of two; {0, 0} is free */
    size_t size, count;
};

bool digest_set_has(const struct digest_set *s, struct digest d);
/* False: it was there before. */
bool digest_set_add(struct digest_set *s, struct digest d);
void digest_set_free(struct digest_set *s);
#endif
