/* operation.h - reads and writes of the Concurrent File System, as a node's program makes them. */
#ifndef CFS_OPERATION_H
#define CFS_OPERATION_H
#include <stdbool.h>
#include <sys/uio.h>
#include "kernel/vtime.h"

struct cfs;
struct cfs_file;
struct cfs_op; /* a read or write under way */
struct io_request;
struct node;

/* Starts a read or write at the file's pointer (at: -1), which advances, or at an offset of the file, which
 * leaves pointers alone. Copies the data to be written. The caller ends the operation with cfs_end(). NULL:
 * EBADF or EFBIG. */
struct cfs_op *cfs_start(struct cfs_file *f, bool write, int64_t at, const struct iovec *parts, int count);
bool cfs_done(struct node *n, const struct cfs_op *op);
void cfs_wait(struct node *n, struct cfs_op *op);
/* Ends an operation that is done: copies what was read to the program's memory, returns how many bytes were
 * moved, and frees op. */
ssize_t cfs_end(struct cfs_op *op);

/* --- for the rest of the file system --- */

/* As ionode_up.answer and ionode_up.room. */
void cfs_answer(void *ctx, struct io_request *r, vtime now);
void cfs_room(void *ctx, struct io_request *r, vtime now);
/* Mode 4: the result of the round's call is in the memory of op's node from `at` on (unison.c). */
void cfs_told(struct cfs_op *op, uint64_t bytes, const char *data, vtime at);
void cfs_free_ops(struct cfs *c);
#endif
