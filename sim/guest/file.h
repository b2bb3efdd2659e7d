/* file.h - an open file of a node: of this computer, or of the simulated machine's file system.
 *
 * Paths under /cfs, and under /pfs, another name for it, belong to the machine's file system (node_system.fs;
 * ENODEV if it has none): opening, reading and writing there takes virtual time. All other paths are this
 * computer's, relative ones from the node's folder (folder.h), at first where the simulator was started; they
 * take no virtual time, but are opened, read and written in its order.
 *
 * file_* functions run on the node's stack and answer as their namesakes in POSIX do: -1 (NULL) with errno.
 * Handlers are held back meanwhile: the C library is no place to interrupt.
 */
#ifndef NODE_FILE_H
#define NODE_FILE_H
#include <stdbool.h>
#include <stdint.h>
#include <sys/stat.h>
#include <sys/types.h>

struct node;
struct node_file;

/* What a kind of file does. Times and order are the caller's affair on this computer's files, and the
 * function's own in the machine's file system (it may wait: it is called between node_enter and node_leave).
 */
struct node_file_class {
    bool simulated;
    ssize_t (*read)(struct node_file *f, void *buf, size_t bytes);
    ssize_t (*write)(struct node_file *f, const void *buf, size_t bytes);
    int64_t (*seek)(struct node_file *f, int64_t offset, int whence);
    int (*stat)(struct node_file *f, struct stat *st);
    int (*truncate)(struct node_file *f, int64_t size);
    int (*close)(struct node_file *f); /* frees f; also off the node, at the end */
};

/* The start of every open file. */
struct node_file {
    const struct node_file_class *class;
    struct node *node;
};

/* The machine's file system. Paths are whole ("/cfs/..."). */
struct node_fs {
    void *ctx;
    struct node_file *(*open)(void *ctx, struct node *n, const char *path, int flags, mode_t permissions);
    int (*unlink)(void *ctx, struct node *n, const char *path);
    int (*rename)(void *ctx, struct node *n, const char *from, const char *to);
    int (*stat)(void *ctx, struct node *n, const char *path, struct stat *st);
};

bool file_is_simulated(const char *path); /* Is it the machine's file system's? */
struct node_file *file_open(struct node *n, const char *path, int flags, mode_t permissions);
/* A file of this computer's that is open already; takes fd over, also when it fails. */
struct node_file *file_of_host(struct node *n, int fd);
ssize_t file_read(struct node_file *f, void *buf, size_t bytes);
ssize_t file_write(struct node_file *f, const void *buf, size_t bytes); /* all, unless there is an error */
int64_t file_seek(struct node_file *f, int64_t offset, int whence);
int file_close(struct node_file *f);
int file_fstat(struct node_file *f, struct stat *st);
int file_truncate(struct node_file *f, int64_t size);
/* Off the node: closes f without taking time. */
void file_drop(struct node_file *f);

int file_stat(struct node *n, const char *path, struct stat *st);
/* The same between node_enter() and node_leave(). */
int file_stat_within(struct node *n, const char *path, struct stat *st);
int file_lstat(struct node *n, const char *path, struct stat *st);
int file_unlink(struct node *n, const char *path);
int file_rename(struct node *n, const char *from, const char *to);
int file_make_folder(struct node *n, const char *path, mode_t permissions);
int file_remove_folder(struct node *n, const char *path);
#endif
