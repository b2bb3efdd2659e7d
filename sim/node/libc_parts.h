/* libc_parts.h - struct node_libc, for the files that serve the C library's calls: libc*.c and stdio.c. */
#ifndef NODE_LIBC_PARTS_H
#define NODE_LIBC_PARTS_H
#include <stddef.h>
#include <stdlib.h>
#include "node/libc.h"
#include "node/descriptors.h"
#include "node/streams.h"

struct node_libc {
    struct streams streams;
    struct descriptors descriptors;
    struct random_data random; /* as glibc's rand() and random(): additive feedback over 31 words */
    char random_state[128];
    struct drand48_data drand48;
    char *strtok_next;
    uint64_t entropy;
    void (**atexit)(void);
    size_t atexit_count;
};

/* strerror, with NX's errors: nx_api/sim/errors.c. */
char *node_strerror(int code);
#endif
