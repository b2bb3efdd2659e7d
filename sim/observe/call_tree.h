/* call_tree.h - the time of each node by path of calls and source line: computing, system time
 * and waits, for programs built with nxcc --profile.
 *
 * A *spot* is a frame with all those above it: relax, called by main. Spots are one tree for all nodes. A
 * *share* is the time that nodes spent at a spot itself, in a line. So a node's shares add up to its
 * computing, system and idle time, to the picosecond. */
#ifndef OBSERVE_CALL_TREE_H
#define OBSERVE_CALL_TREE_H
#include <jansson.h>
#include "machine/machine.h"

enum spot_kind {
    SPOT_ROOT,
    SPOT_FUNCTION, /* of the program */
    SPOT_INLINED,  /* a function that is inlined into the spot above */
    SPOT_LIBRARY,  /* a function of the C library, or another with a price in the cost table */
    SPOT_CALL,     /* of NX; its shares are system time */
    SPOT_WAITING,  /* in the call above */
    SPOT_OTHER     /* "(handlers)" and what is in no call: its name says so */
};

struct spot {
    enum spot_kind kind;
    uint32_t parent;         /* the root is the first spot, its own parent */
    const char *name, *file; /* in the first node's program, or constant */
    int32_t line;            /* of the function's beginning */
    /* for collecting */
    const struct nxc_body *body; /* of the first node's program; NULL: none */
    uint32_t *shares;            /* by the body's weights */
    uint32_t children, next;     /* 0: none */
    uint32_t first_share;        /* +1; 0: none */
};

struct share {
    uint32_t spot;
    const char *file;
    int32_t line; /* 0: none */
    bool computing;
    uint32_t next;  /* +1, of the spot; 0: none */
    int64_t *units; /* by node: cost units of computing */
    vtime *time;    /* by node */
};

struct call_tree {
    struct spot *spots;
    struct share *shares;
    uint32_t spot_count, share_count, spot_room, share_room, nodes;
};

/* Does the node's program keep paths? */
bool call_tree_possible(const struct node *n);
/* All nodes run one program that keeps paths. */
struct call_tree call_tree_collect(const struct machine *m);
void call_tree_free(struct call_tree *t);
/* The tree as an object: "spots" are texts "PARENT KIND LINE NAME\tFILE", "shares" are texts
 * "SPOT LINE FILE\tNODES:TIME NODES:TIME ...": each of these nodes spent such a time, in picoseconds. */
json_t *call_tree_json(const struct call_tree *t);
#endif
