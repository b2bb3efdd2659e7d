/* descriptors.h - a node's file descriptors: 0, 1 and 2 are its standard streams, the others open files. */
#ifndef NODE_DESCRIPTORS_H
#define NODE_DESCRIPTORS_H
#include "guest/file.h"

struct cfs_op; /* cfs/cfs.h */

enum { NODE_DESCRIPTORS = 64, NODE_IO_IDS = 128 };

/* A read or write that iread or iwrite began. */
struct io_id {
    bool used;
    struct cfs_op *op; /* under way in the machine's file system; NULL: done at once */
    ssize_t moved;     /* bytes, if done at once */
};

struct open_files {
    struct node_file *file[NODE_DESCRIPTORS];
    char *path[NODE_DESCRIPTORS]; /* that it was opened by */
    struct io_id io[NODE_IO_IDS];
};

/* Most programs open no files: then a node has no room for them. */
struct descriptors {
    struct open_files *open; /* NULL: there has been none yet */
    bool closed[3];          /* of the standard ones, by the program */
};

struct open_files *descriptors_open(struct node *n); /* makes room if there is none */

/* The lowest free number for f; -1 with errno EMFILE (f is closed). f NULL: -1. */
int descriptor_new(struct node *n, struct node_file *f, const char *path);
/* Its file; NULL with errno EBADF when it has none. */
struct node_file *descriptor_file(struct node *n, int fd);
/* What it was opened by, for messages; "?" when it is not open. */
const char *descriptor_path(const struct node *n, int fd);
void descriptors_close(struct descriptors *d); /* off the node */
#endif
