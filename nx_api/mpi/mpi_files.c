/* mpi_files.c - the NX calls on files. Files under /cfs lie in a folder of the host's (mpi_paths.h); all
 * others are the host's own.
 *
 * iread and iwrite begin jobs (io_jobs.h) in M_UNIX, M_RECORD and M_ASYNC, and at an offset. In the other
 * modes the next transfer, of this node or another, begins where this one ends: so they return when all
 * bytes have been moved. All other calls wait for the jobs of their file. */
#include "nx_api/mpi/mpi_files.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include "nx_api/calls/file_calls.h"
#include "nx_api/mpi/io_jobs.h"
#include "nx_api/mpi/mpi_paths.h"
#include "nx_api/mpi/shared_pointer.h"

enum { IO_IDS = 128 };

static struct open_file *table;
static int table_size;
static int32_t pointers; /* how many shared pointers have been numbered */
/* Of iread and iwrite. */
struct io_id {
    bool used;
    int fd;
    struct io_job *job; /* NULL: it was done at once, and has moved so many bytes */
    long moved;
};
static struct io_id io_ids[IO_IDS];

/* --- open files --- */

struct open_file *files_find(int fd)
{
    if (fd < 0 || syscall(SYS_fcntl, fd, F_GETFD) < 0)
        return NULL;
    if (fd >= table_size) {
        struct open_file *more = realloc(table, ((size_t)fd + 1) * sizeof *table);
        if (!more)
            node_fail(node_self(), "out of memory");
        memset(more + table_size, 0, (size_t)(fd + 1 - table_size) * sizeof *table);
        table = more;
        table_size = fd + 1;
    }
    return &table[fd];
}

static void forget(struct open_file *f)
{
    free(f->path);
    *f = (struct open_file){0};
}

void files_opened(int fd, const char *path)
{
    struct open_file *f = files_find(fd);
    if (!f)
        return;
    forget(f);
    f->path = strdup(path);
}

void files_copied(int fd, int to)
{
    if (!files_find(to) || !files_find(fd))
        return;
    struct open_file *copy = files_find(to), *f = files_find(fd); /* the table does not move any more */
    forget(copy);
    *copy = *f;
    copy->path = f->path ? strdup(f->path) : NULL;
}

static const char *name_of(const struct open_file *f)
{
    return f->path ? f->path : "the file";
}

/* Do calls in the file's I/O mode depend on other nodes' calls? */
static bool shares(const struct open_file *f)
{
    return f->mode != M_UNIX && f->mode != M_ASYNC;
}

static bool is_cfs(const struct open_file *f)
{
    return path_is_cfs(f->path);
}

/* --- errors --- */

/* The error of errno. */
static long fail(const char *what)
{
    int why = errno;
    return node_error(node_self(), why, "%s: %s", what, strerrordesc_np(why));
}

static struct open_file *file_of(int fd)
{
    struct open_file *f = files_find(fd);
    if (!f)
        node_error(node_self(), EBADF, "%d is not an open file", fd);
    return f;
}

/* --- reading and writing --- */

/* lseek of the file's own pointer, which only M_UNIX and M_ASYNC move by. */
static off_t own_seek(int fd, off_t offset, int whence)
{
    return syscall(SYS_lseek, fd, offset, whence);
}

static int64_t length(const struct iovec *parts, int count)
{
    int64_t sum = 0;
    for (int i = 0; i < count; i++)
        sum += (int64_t)parts[i].iov_len;
    return sum;
}

/* M_GLOBAL: all nodes make the same call. Each node reads for itself; node 0 writes, and the others wait for
 * node 0. */
static ssize_t move_alike(struct node *n, bool write_it, int fd, const struct iovec *parts, int count)
{
    struct open_file *f = files_find(fd);
    int32_t pointer = f->pointer;
    int64_t offset = own_seek(fd, 0, SEEK_CUR), bytes = length(parts, count);
    shared_check(n, pointer, f->round, bytes);
    table[fd].round++;
    if (write_it)
        shared_borrow(n, M_SYNC, pointer, 0);
    ssize_t moved = write_it && n->id != 0 ? bytes : io_move(write_it, fd, offset, parts, count);
    int why = errno;
    if (write_it)
        shared_give_back(n, M_SYNC, pointer, 0);
    own_seek(fd, offset + (moved > 0 ? moved : 0), SEEK_SET);
    errno = why;
    return moved;
}

/* M_RECORD: the place of this node's bytes in the round. The file's own pointer follows, for iseof. */
static int64_t next_record(struct node *n, int fd, int64_t bytes)
{
    const struct open_file f = *files_find(fd);
    shared_check(n, f.pointer, f.round, bytes);
    table[fd].next = f.next + (int64_t)n->sys->count * bytes;
    table[fd].round++;
    own_seek(fd, table[fd].next, SEEK_SET);
    return f.next + n->id * bytes;
}

/* M_LOG and M_SYNC: at the shared pointer. The file's own pointer follows, for iseof. */
static ssize_t move_in_turn(struct node *n, bool write_it, int fd, const struct iovec *parts, int count)
{
    const struct open_file f = *files_find(fd);
    int64_t offset = shared_borrow(n, f.mode, f.pointer, own_seek(fd, 0, SEEK_CUR));
    ssize_t moved = io_move(write_it, fd, offset, parts, count);
    int why = errno;
    int64_t behind = offset + (moved > 0 ? moved : 0);
    shared_give_back(n, f.mode, f.pointer, behind);
    own_seek(fd, behind, SEEK_SET);
    errno = why;
    return moved;
}

static ssize_t move_shared(struct node *n, bool write_it, int fd, const struct iovec *parts, int count)
{
    switch (files_find(fd)->mode) {
    case M_GLOBAL:
        return move_alike(n, write_it, fd, parts, count);
    case M_RECORD:
        return io_move(write_it, fd, next_record(n, fd, length(parts, count)), parts, count);
    default:
        return move_in_turn(n, write_it, fd, parts, count);
    }
}

long nx_move(bool write_it, int fd, int64_t at, const struct iovec *parts, int count)
{
    struct open_file *f = file_of(fd);
    if (!f || nx_check_parts(node_self(), parts, count) < 0)
        return -1;
    io_settle(fd);
    ssize_t moved = at != AT_POINTER || !shares(f) ? io_move(write_it, fd, at, parts, count)
                                                   : move_shared(node_self(), write_it, fd, parts, count);
    return moved < 0 ? fail(name_of(files_find(fd))) : moved;
}

/* --- reading and writing while the program computes --- */

/* Is the file open for it? A job would tell too late. */
static bool is_open_for(bool write_it, int fd)
{
    int flags = (int)syscall(SYS_fcntl, fd, F_GETFL) & O_ACCMODE;
    return flags == O_RDWR || flags == (write_it ? O_WRONLY : O_RDONLY);
}

static long begin(struct io_id *id, bool write_it, int fd, int64_t at, const struct iovec *parts, int count)
{
    struct open_file *f = file_of(fd);
    if (!f || nx_check_parts(node_self(), parts, count) < 0)
        return -1;
    if (at == AT_POINTER && f->mode == M_RECORD) {
        at = next_record(node_self(), fd, length(parts, count));
    } else if (at == AT_POINTER && shares(f)) {
        id->moved = nx_move(write_it, fd, at, parts, count);
        return id->moved;
    }
    f = files_find(fd);
    errno = EBADF;
    if (is_open_for(write_it, fd))
        id->job = io_begin(write_it, fd, at, parts, count);
    return id->job ? 0 : fail(name_of(f));
}

long nx_move_later(bool write_it, int fd, int64_t at, const struct iovec *parts, int count)
{
    long id = 0;
    while (id < IO_IDS && io_ids[id].used)
        id++;
    if (id == IO_IDS)
        return node_error(node_self(), EQNOMID, "out of ids (%d): iowait or iodone give them back", IO_IDS);
    io_ids[id] = (struct io_id){.fd = fd};
    if (begin(&io_ids[id], write_it, fd, at, parts, count) < 0)
        return -1;
    io_ids[id].used = true;
    return id + 1; /* 0 is none, for programs */
}

bool files_are_moved(struct node *n, void *job)
{
    (void)n;
    return io_is_done(job);
}

static struct io_id *find_id(word id)
{
    if (id >= 1 && id <= IO_IDS && io_ids[id - 1].used)
        return &io_ids[id - 1];
    node_error(node_self(), EQMID, "%d is no id in use", id);
    return NULL;
}

/* Frees an id whose job is done. */
static long give_back(struct io_id *id)
{
    id->used = false;
    if (!id->job)
        return id->moved;
    const struct open_file *f = files_find(id->fd);
    long moved = io_end(id->job);
    return moved < 0 ? fail(f ? name_of(f) : "the file") : moved;
}

long nxs_iowait(word id)
{
    struct io_id *i = find_id(id);
    if (!i)
        return -1;
    nx_about(node_self(), id);
    if (i->job)
        node_wait(node_self(), files_are_moved, i->job);
    return give_back(i);
}

long nxs_iodone(word id)
{
    struct io_id *i = find_id(id);
    if (!i)
        return -1;
    if (i->job && !io_is_done(i->job))
        return 0;
    return give_back(i) < 0 ? -1 : 1;
}

/* --- the C library's calls, for files whose pointer is shared --- */

ssize_t node_read(int fd, void *buf, size_t len) NX_EXPORT("read");
ssize_t node_write(int fd, const void *buf, size_t len) NX_EXPORT("write");
int node_close(int fd) NX_EXPORT("close");
int node_dup(int fd) NX_EXPORT("dup");
int node_dup2(int fd, int to) NX_EXPORT("dup2");
off_t node_lseek(int fd, off_t offset, int whence) NX_EXPORT("lseek");
off_t node_lseek64(int fd, off_t offset, int whence) NX_EXPORT("lseek64") __attribute__((alias("lseek")));

static bool is_shared(int fd)
{
    return fd >= 0 && fd < table_size && shares(&table[fd]);
}

ssize_t node_read(int fd, void *buf, size_t len)
{
    struct iovec part = {buf, len};
    io_settle(fd);
    return is_shared(fd) ? move_shared(node_self(), false, fd, &part, 1) : syscall(SYS_read, fd, buf, len);
}

ssize_t node_write(int fd, const void *buf, size_t len)
{
    struct iovec part = {(void *)(uintptr_t)buf, len};
    io_settle(fd);
    return is_shared(fd) ? move_shared(node_self(), true, fd, &part, 1) : syscall(SYS_write, fd, buf, len);
}

/* Sets the pointer that nodes share; the file's own follows. In M_SYNC all nodes seek, each in its turn; but
 * to ask where the pointer is takes no turn. */
static off_t seek_shared(struct node *n, int fd, off_t offset, int whence)
{
    const struct open_file f = *files_find(fd);
    const off_t own = own_seek(fd, 0, SEEK_CUR);
    bool borrows = f.mode == M_LOG || (f.mode == M_SYNC && (offset || whence != SEEK_CUR));
    if (borrows)
        own_seek(fd, shared_borrow(n, f.mode, f.pointer, own), SEEK_SET);
    off_t at = own_seek(fd, offset, whence);
    int why = errno;
    off_t now = own_seek(fd, 0, SEEK_CUR);
    if (borrows)
        shared_give_back(n, f.mode, f.pointer, now);
    if (f.mode == M_RECORD)
        table[fd].next = now;
    errno = why;
    return at;
}

off_t node_lseek(int fd, off_t offset, int whence)
{
    io_settle(fd);
    return is_shared(fd) ? seek_shared(node_self(), fd, offset, whence) : own_seek(fd, offset, whence);
}

int node_close(int fd)
{
    io_settle(fd);
    if (fd >= 0 && fd < table_size)
        forget(&table[fd]);
    return (int)syscall(SYS_close, fd);
}

int node_dup(int fd)
{
    int to = (int)syscall(SYS_dup, fd);
    files_copied(fd, to);
    return to;
}

int node_dup2(int fd, int to)
{
    io_settle(to);
    int answer = (int)syscall(SYS_dup2, fd, to);
    if (answer >= 0 && fd != to)
        files_copied(fd, to);
    return answer;
}

/* --- opening and modes --- */

static long set_mode(int fd, long mode)
{
    struct node *n = node_self();
    struct open_file *f = file_of(fd);
    if (!f)
        return -1;
    io_settle(fd);
    if (nx_check_io_mode(n, name_of(f), is_cfs(f), mode) < 0)
        return -1;
    if (!is_cfs(f))
        mode = M_UNIX;
    if (f->mode == mode)
        return 0;
    f->mode = (int)mode;
    if (!shares(f))
        return 0;
    f->pointer = pointers++;
    f->next = own_seek(fd, 0, SEEK_CUR);
    f->round = 0;
    if ((mode == M_SYNC || mode == M_GLOBAL) && n->id == 0) /* the pointer starts at node 0 */
        shared_start(n, f->pointer, f->next);
    return 0;
}

static long open_one(const char *path, int flags, int mode, unsigned permissions)
{
    int fd = path_open(path, flags, permissions);
    if (fd < 0)
        return fail(path);
    if (set_mode(fd, mode) == 0)
        return fd;
    node_close(fd);
    return -1;
}

long nx_open_one(const char *call, const char *path, int flags, int mode, unsigned permissions, nx_end *end)
{
    struct node *n = node_self();
    node_enter(n, call);
    return end(n, open_one(path, flags, mode, permissions));
}

long nxs_setiomode(word fd, word mode)
{
    return set_mode(fd, mode);
}

long nxs_iomode(word fd)
{
    const struct open_file *f = file_of(fd);
    return f ? f->mode : -1;
}

/* --- pointers and sizes --- */

int64_t nx_seek(struct node *n, int fd, int64_t offset, int whence)
{
    const struct open_file *f = file_of(fd);
    (void)n;
    if (!f)
        return -1;
    int64_t at = lseek(fd, offset, whence);
    return at < 0 ? fail(name_of(f)) : at;
}

/* Makes a file at least so large. */
static int64_t grow(int fd, int64_t offset, int whence)
{
    struct stat st;
    if (fstat(fd, &st))
        return -1;
    int64_t from = whence == SIZE_SET   ? 0
                   : whence == SIZE_CUR ? own_seek(fd, 0, SEEK_CUR)
                   : whence == SIZE_END ? st.st_size
                                        : -1;
    if (from < 0 || from + offset < 0) {
        errno = EINVAL;
        return -1;
    }
    if (from + offset <= st.st_size)
        return st.st_size;
    return ftruncate(fd, from + offset) ? -1 : from + offset;
}

int64_t nx_resize(struct node *n, int fd, int64_t offset, int whence)
{
    const struct open_file *f = file_of(fd);
    if (!f)
        return -1;
    if (!is_cfs(f))
        return node_error(n, EINVAL, "%s: only files under /cfs or /pfs can be sized", name_of(f));
    io_settle(fd);
    int64_t size = grow(fd, offset, whence);
    return size < 0 ? fail(name_of(f)) : size;
}

/* The state of an open file: 0, or -1 with the error. */
static long stat_file(int fd, struct stat *st)
{
    const struct open_file *f = file_of(fd);
    if (!f)
        return -1;
    io_settle(fd);
    return fstat(fd, st) ? fail(name_of(f)) : 0;
}

long nxs_iseof(word fd)
{
    struct stat st;
    if (stat_file(fd, &st) < 0)
        return -1;
    return own_seek(fd, 0, SEEK_CUR) >= st.st_size;
}

/* All disks are one. */
long nxs_restrictvol(word fd, word count, const int disks[])
{
    const struct open_file *f = file_of(fd);
    if (!f)
        return -1;
    if (is_cfs(f) && count >= 1 && disks)
        return 0;
    errno = EINVAL;
    return fail(name_of(f));
}

/* --- state --- */

long nx_stat_path(const char *call, bool link, const char *path, struct estat *e, nx_end *end)
{
    struct node *n = node_self();
    struct stat st;
    char space[PATH_MAX];
    node_enter(n, call);
    const char *here = path_here(path, space);
    if (!here || fstatat(AT_FDCWD, here, &st, link ? AT_SYMLINK_NOFOLLOW : 0))
        return end(n, fail(path));
    nx_put_estat(n, e, &st);
    return end(n, 0);
}

long nxs_festat(word fd, struct estat *e)
{
    struct stat st;
    if (stat_file(fd, &st) < 0)
        return -1;
    nx_put_estat(node_self(), e, &st);
    return 0;
}
