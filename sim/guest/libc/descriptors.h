/* descriptors.h - a node's file descriptors: 0, 1 and 2 are its standard streams, the others open files. */
#ifndef GUEST_LIBC_DESCRIPTORS_H
#define GUEST_LIBC_DESCRIPTORS_H
#include "guest/libc/file.h"
#include "guest/libc/standard_files.h"

struct cfs_op; /* cfs/cfs.h */

enum { NODE_DESCRIPTORS = 64, NODE_IO_IDS = 128 };

/* A read or write that iread or iwrite began. */
struct io_id {
    bool used;
    struct cfs_op *op; /* under way in the machine's file system; NULL: done at once */
    ssize_t moved;     /* bytes, if done at once */
};

struct open_files {
    struct node_file *file[NODE_DESCRIPTORS]; /* from 3 on */
    char *path[NODE_DESCRIPTORS];             /* the name by which the file was opened */
    struct io_id io[NODE_IO_IDS];
};

/* Descriptors 0, 1 and 2. */
struct standard_files {
    struct node_file *file[3]; /* NULL: the program has closed it */
    struct standard_file at_first[3];
};

/* Most programs open no files, and print on one node only: so the tables are made when they are needed. */
struct descriptors {
    struct open_files *open;         /* NULL: not made yet */
    struct standard_files *standard; /* NULL: as they are at first */
};

struct open_files *descriptors_open(struct node *n); /* makes the table if needed */

/* As file_open(); also a standard stream of the node's by its name, such as /dev/stdout. */
struct node_file *descriptor_open(struct node *n, const char *path, int flags, mode_t permissions);
/* Gives f the lowest free number and returns it. If no number is free, closes f and returns -1 with errno
 * EMFILE. Returns -1 if f is NULL. */
int descriptor_new(struct node *n, struct node_file *f, const char *path);
/* As descriptor_new(), but f gets the number fd if that is free. */
int descriptor_reuse(struct node *n, int fd, struct node_file *f, const char *path);
/* The file of a descriptor; NULL with errno EBADF if the descriptor is not open. */
struct node_file *descriptor_file(struct node *n, int fd);
/* The name by which a descriptor was opened, for messages; "?" if the descriptor is not open. */
const char *descriptor_path(const struct node *n, int fd);
/* As close(), and fcntl(fd, F_DUPFD, least). */
int descriptor_close(struct node *n, int fd);
int descriptor_copy_free(struct node *n, int fd, int least);
/* Closes all files without taking virtual time. Called when the program does not run any more. */
void descriptors_close(struct descriptors *d);
#endif
