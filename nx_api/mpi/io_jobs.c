/* io_jobs.c - see io_jobs.h. */
#include "nx_api/mpi/io_jobs.h"
#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>
#include "nx_api/mpi/bells.h"

struct io_job {
    struct io_job *next;
    bool write;
    int fd, count;
    int64_t offset;
    struct iovec *parts;
    char *copy; /* of what is to be written */
    long moved;
    int error;
    atomic_bool done;
};

/* A file's jobs, the first of which is being done. */
struct io_file {
    struct io_job *first, **end;
    uint32_t writes; /* of them */
};

/* lock protects the files and their jobs, but for `done`. A job that is done belongs to the program's
 * thread. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static struct io_file **files; /* by file descriptor; only the program's thread changes the table */
static int file_count;

/* --- moving --- */

/* The bytes moved; -1 and errno if none could be, or not all could be written: few programs look whether a
 * write was complete, and a full disk must not cost them their results. */
static ssize_t move_part(bool write_it, int fd, char *at, size_t len, int64_t offset)
{
    size_t moved = 0;
    while (moved < len) {
        ssize_t r = offset < 0 ? syscall(write_it ? SYS_write : SYS_read, fd, at + moved, len - moved)
                    : write_it ? pwrite(fd, at + moved, len - moved, offset + (int64_t)moved)
                               : pread(fd, at + moved, len - moved, offset + (int64_t)moved);
        if (r < 0 && errno == EINTR)
            continue;
        if (r < 0)
            return moved > 0 && !write_it ? (ssize_t)moved : -1;
        if (r == 0)
            break;
        moved += (size_t)r;
    }
    return (ssize_t)moved;
}

long io_move(bool write_it, int fd, int64_t offset, const struct iovec *parts, int count)
{
    long moved = 0;
    for (int i = 0; i < count; i++) {
        ssize_t r =
            move_part(write_it, fd, parts[i].iov_base, parts[i].iov_len, offset < 0 ? -1 : offset + moved);
        if (r < 0)
            return moved > 0 && !write_it ? moved : -1;
        moved += r;
        if ((size_t)r < parts[i].iov_len)
            break;
    }
    return moved;
}

/* --- a file's thread --- */

static void remove_first(struct io_file *f)
{
    struct io_job *job = f->first;
    f->first = job->next;
    if (!f->first)
        f->end = &f->first;
    f->writes -= job->write;
}

static void *work(void *file)
{
    struct io_file *f = file;
    pthread_mutex_lock(&lock);
    for (;;) {
        while (!f->first)
            pthread_cond_wait(&changed, &lock);
        struct io_job *job = f->first;
        pthread_mutex_unlock(&lock);
        job->moved = io_move(job->write, job->fd, job->offset, job->parts, job->count);
        job->error = errno;
        pthread_mutex_lock(&lock);
        remove_first(f);
        atomic_store(&job->done, true);
        pthread_cond_broadcast(&changed);
        bell_ring_here();
    }
    return NULL;
}

/* The program's own thread gets all signals, but for that of a pipe without a reader. */
static int start_thread(struct io_file *f)
{
    sigset_t all, before;
    pthread_t thread;
    sigfillset(&all);
    sigdelset(&all, SIGPIPE);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    int error = pthread_create(&thread, NULL, work, f);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    if (!error)
        pthread_detach(thread);
    return error;
}

static struct io_file *find(int fd)
{
    return fd >= 0 && fd < file_count ? files[fd] : NULL;
}

static bool make_room(int fd)
{
    if (fd < file_count)
        return true;
    struct io_file **more = reallocarray(files, (size_t)fd + 1, sizeof(struct io_file *));
    if (!more)
        return false;
    memset(more + file_count, 0, (size_t)(fd + 1 - file_count) * sizeof(struct io_file *));
    files = more;
    file_count = fd + 1;
    return true;
}

/* NULL and errno: there is no room. */
static struct io_file *file_with_thread(int fd)
{
    struct io_file *f = find(fd);
    if (f)
        return f;
    f = make_room(fd) ? calloc(1, sizeof *f) : NULL;
    if (!f)
        return NULL;
    f->end = &f->first;
    int error = start_thread(f);
    if (error) {
        free(f);
        errno = error;
        return NULL;
    }
    return files[fd] = f;
}

/* --- jobs --- */

static void free_job(struct io_job *job)
{
    free(job->parts);
    free(job->copy);
    free(job);
}

/* The bytes of all parts, one behind the other. */
static bool copy_bytes(struct io_job *job, const struct iovec *parts, int count)
{
    size_t len = 0;
    for (int i = 0; i < count; i++)
        len += parts[i].iov_len;
    job->copy = malloc(len + 1);
    if (!job->copy)
        return false;
    job->parts[0] = (struct iovec){job->copy, len};
    job->count = 1;
    char *at = job->copy;
    for (int i = 0; i < count; i++) {
        if (parts[i].iov_len)
            memcpy(at, parts[i].iov_base, parts[i].iov_len);
        at += parts[i].iov_len;
    }
    return true;
}

static struct io_job *new_job(bool write, int fd, int64_t offset, const struct iovec *parts, int count)
{
    struct io_job *job = calloc(1, sizeof *job);
    if (!job)
        return NULL;
    job->write = write, job->fd = fd, job->offset = offset, job->count = count;
    job->parts = calloc((size_t)count + 1, sizeof *parts);
    if (!job->parts || (write && !copy_bytes(job, parts, count))) {
        free_job(job);
        return NULL;
    }
    if (!write && count)
        memcpy(job->parts, parts, (size_t)count * sizeof *parts);
    return job;
}

struct io_job *io_begin(bool write, int fd, int64_t offset, const struct iovec *parts, int count)
{
    struct io_file *f = file_with_thread(fd);
    struct io_job *job = f ? new_job(write, fd, offset, parts, count) : NULL;
    if (!job)
        return NULL;
    pthread_mutex_lock(&lock);
    *f->end = job;
    f->end = &job->next;
    f->writes += write;
    pthread_cond_broadcast(&changed);
    pthread_mutex_unlock(&lock);
    return job;
}

bool io_is_done(const struct io_job *job)
{
    return atomic_load(&job->done);
}

long io_end(struct io_job *job)
{
    long moved = job->moved;
    int why = job->error;
    free_job(job);
    errno = why;
    return moved;
}

void io_settle(int fd)
{
    struct io_file *f = find(fd);
    if (!f)
        return;
    pthread_mutex_lock(&lock);
    while (f->first)
        pthread_cond_wait(&changed, &lock);
    pthread_mutex_unlock(&lock);
}

void io_settle_all(void)
{
    pthread_mutex_lock(&lock);
    for (int fd = 0; fd < file_count; fd++)
        while (files[fd] && files[fd]->writes)
            pthread_cond_wait(&changed, &lock);
    pthread_mutex_unlock(&lock);
}
