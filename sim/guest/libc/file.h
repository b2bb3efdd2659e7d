/* file.h - an open file of a node: of this computer, or of the simulated machine's file system.
 *
 * Paths under /cfs, and under its other name /pfs, belong to the machine's file system (node_system.fs;
 * errno is ENODEV if the machine has none): a call there takes virtual time. All other paths are this
 * computer's. A relative path starts from the node's folder (folder.h), which is at first the folder in
 * which the simulator was started. A call on a file of this computer takes no virtual time, but is
 * committed in the total order.
 *
 * Of this computer, programs may use what the machine's fence lets through (fence.h). A call that the fence
 * refuses ends the run with a message.
 *
 * The file_* functions run on the node's stack and answer as their namesakes in POSIX do: -1 or NULL with
 * errno. Handlers are masked meanwhile: the C library must not be interrupted. */
#ifndef GUEST_LIBC_FILE_H
#define GUEST_LIBC_FILE_H
#include <stdbool.h>
#include <stdint.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/types.h>

struct node;
struct node_file;

/* What a kind of file does. For a file of this computer, the caller commits the call in the total order. A
 * function of the machine's file system keeps time itself and may wait: it is called between node_enter()
 * and node_leave(). */
struct node_file_class {
    bool simulated;
    bool terminal; /* the run's own input or output: standard_files.h */
    ssize_t (*read)(struct node_file *f, void *buf, size_t bytes);
    ssize_t (*write)(struct node_file *f, const void *buf, size_t bytes);
    int64_t (*seek)(struct node_file *f, int64_t offset, int whence);
    int (*stat)(struct node_file *f, struct stat *st);
    int (*truncate)(struct node_file *f, int64_t size);
    int (*close)(struct node_file *f); /* frees f; at a run's end also called when no program runs */
};

/* The start of every open file. */
struct node_file {
    const struct node_file_class *class;
    struct node *node;
    unsigned more; /* descriptors that are open on the file beside the first: dup() */
    int flags;     /* of open() */
};

/* The machine's file system. Paths are absolute ("/cfs/..."). */
struct node_fs {
    void *ctx;
    struct node_file *(*open)(void *ctx, struct node *n, const char *path, int flags, mode_t permissions);
    int (*unlink)(void *ctx, struct node *n, const char *path);
    int (*rename)(void *ctx, struct node *n, const char *from, const char *to);
    int (*stat)(void *ctx, struct node *n, const char *path, struct stat *st);
    char *(*names)(void *ctx, struct node *n, const char *path); /* as file_names() */
};

bool file_is_simulated(const char *path); /* Does the path belong to the machine's file system? */
struct node_file *file_open(struct node *n, const char *path, int flags, mode_t permissions);
/* As file_open(), but of a file that may only be read O_RDWR gets EROFS: OPEN without ACTION= asks for O_RDWR
 * first, and then for less. */
struct node_file *file_open_fortran(struct node *n, const char *path, int flags, mode_t permissions);
/* Makes a new file as by O_RDWR | O_CREAT | O_EXCL. Unlike others, the file may also be in this computer's
 * folder for temporary files. */
struct node_file *file_open_temporary(struct node *n, const char *path, int flags);
/* A file of this computer that is open already as fd, by these flags; NULL if fd is negative. The file owns
 * fd. */
struct node_file *file_of_host(struct node *n, int fd, int flags);
/* As fcntl(fd, F_GETFL), and F_SETFL: of O_NONBLOCK, which changes nothing, as files never wait for others.
 * EINVAL if O_APPEND would change. */
int file_flags(const struct node_file *f);
int file_set_flags(struct node_file *f, int to);
ssize_t file_read(struct node_file *f, void *buf, size_t bytes);
/* Writes all bytes unless there is an error. */
ssize_t file_write(struct node_file *f, const void *buf, size_t bytes);
int64_t file_seek(struct node_file *f, int64_t offset, int whence);
int file_close(struct node_file *f); /* the file stays open while there are more descriptors of it */
int file_fstat(struct node_file *f, struct stat *st);
int file_truncate(struct node_file *f, int64_t size);
/* As file_close(), without taking time. Called when the program does not run any more. */
void file_drop(struct node_file *f);

int file_stat(struct node *n, const char *path, struct stat *st);
/* As file_stat(), called between node_enter() and node_leave(). */
int file_stat_within(struct node *n, const char *path, struct stat *st);
int file_lstat(struct node *n, const char *path, struct stat *st);
ssize_t file_readlink(struct node *n, const char *path, char *buf, size_t size);
/* The names in a folder, for free(): folder_names.h. */
char *file_names(struct node *n, const char *path);
/* In the machine's file system they change nothing: it has no permissions and no dates. */
int file_chmod(struct node *n, const char *path, mode_t permissions);
int file_utimes(struct node *n, const char *path, const struct timeval times[2]);
int file_unlink(struct node *n, const char *path);
int file_rename(struct node *n, const char *from, const char *to);
int file_make_folder(struct node *n, const char *path, mode_t permissions);
int file_remove_folder(struct node *n, const char *path);
#endif
