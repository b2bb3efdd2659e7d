/* atomic_file.c - see atomic_file.h. */
#include "files/atomic_file.h"
#include "files/left_over.h"
#include "kernel/xalloc.h"
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define UNFINISHED ".unfinished-" /* and six letters that are random */

/* The temporary name of the file that was begun last; NULL: it is finished. */
static char *volatile begun_last;

static void forget(struct atomic_file *f)
{
    if (f->unfinished == begun_last)
        begun_last = NULL;
    if (f->lock >= 0)
        close(f->lock);
    free(f->path);
    free(f->unfinished);
}

static char *cannot_be_written(const char *path, int why)
{
    return xasprintf("%s cannot be written: %s", strcmp(path, "-") ? path : "standard output", strerror(why));
}

static bool fail(struct atomic_file *f, int why, char **error)
{
    *error = cannot_be_written(f->path, why);
    if (f->unfinished)
        unlink(f->unfinished);
    forget(f);
    return false;
}

static bool is_written_through(const char *path)
{
    struct stat st;
    return lstat(path, &st) == 0 && !S_ISREG(st.st_mode);
}

/* The folder of the path, malloc'd, with / behind it unless it is the current one. */
static char *folder_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? xstrndup(path, (size_t)(slash - path) + 1) : xstrdup(".");
}

/* Why what is at the path cannot be written into, as an errno; 0: it can, or a link leads to no file yet. */
static int obstacle_in(const char *path)
{
    struct stat st;
    if (stat(path, &st) != 0)
        return 0;
    return S_ISDIR(st.st_mode) ? EISDIR : access(path, W_OK) == 0 ? 0 : errno;
}

/* Why no file can be made in the folder of the path, as an errno; 0: it can. */
static int obstacle_beside(const char *path)
{
    char *folder = folder_of(path);
    int why = access(folder, W_OK | X_OK) == 0 ? 0 : errno;
    free(folder);
    return why;
}

bool atomic_file_possible(const char *path, char **error)
{
    if (!strcmp(path, "-"))
        return true;
    int why = is_written_through(path) ? obstacle_in(path) : obstacle_beside(path);
    return !why || (*error = cannot_be_written(path, why), false);
}

/* Makes a file whose name is random, not made of the process id: processes of several computers may share the
 * folder. A signal waits until it is noted for drop_and_end(). */
static int make_noted(struct atomic_file *f)
{
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    f->unfinished = xasprintf("%s" UNFINISHED "XXXXXX", f->path);
    int fd = mkostemp(f->unfinished, O_CLOEXEC), why = errno;
    begun_last = fd < 0 ? NULL : f->unfinished;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    errno = why;
    return fd;
}

static int make_unfinished(struct atomic_file *f)
{
    for (;;) {
        int fd = make_noted(f);
        if (fd < 0 || flock(fd, LOCK_EX) != 0 || left_over_is_there(f->unfinished, fd))
            return fd;
        close(fd); /* taken for a dead process's before it was locked */
        begun_last = NULL;
        free(f->unfinished);
    }
}

/* (The lock lasts until the file has its name.) */
static FILE *begin_unfinished(struct atomic_file *f)
{
    mode_t without = umask(0);
    umask(without);
    int fd = make_unfinished(f);
    if (fd < 0)
        return NULL;
    fchmod(fd, 0666 & ~without);
    f->lock = fcntl(fd, F_DUPFD_CLOEXEC, 0);
    return fdopen(fd, "w");
}

static bool is_unfinished(const char *entry, const void *name)
{
    size_t length = strlen(name);
    return strncmp(entry, name, length) == 0 &&
           strncmp(entry + length, UNFINISHED, sizeof UNFINISHED - 1) == 0 &&
           strlen(entry + length) == sizeof UNFINISHED - 1 + 6;
}

void atomic_file_remove_left(const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    char *folder = folder_of(path);
    left_over_remove_all(folder, is_unfinished, name);
    free(folder);
}

/* mode: of a file that is written through. */
static bool begin(struct atomic_file *f, const char *path, const char *mode, char **error)
{
    *f = (struct atomic_file){.path = xstrdup(path), .lock = -1};
    if (!strcmp(path, "-"))
        f->out = stdout;
    else
        f->out = is_written_through(path) ? fopen(path, mode) : begin_unfinished(f);
    return f->out || fail(f, errno, error);
}

bool atomic_file_begin(struct atomic_file *f, const char *path, char **error)
{
    return begin(f, path, "we", error);
}

bool atomic_file_reserve(struct atomic_file *f, const char *path, char **error)
{
    return begin(f, path, "ae", error);
}

void atomic_file_replace(struct atomic_file *f)
{
    if (!f->unfinished && f->out != stdout)
        (void)!ftruncate(fileno(f->out), 0); /* pipes and devices have nothing to lose */
}

static bool close_all(struct atomic_file *f)
{
    bool written = !ferror(f->out);
    if (f->out == stdout)
        return fflush(f->out) == 0 && written;
    return fclose(f->out) == 0 && written;
}

/* Sets errno to why an earlier write failed, of which stdio keeps no reason: tries another one, to a file
 * that is lost anyway. */
static void find_reason(const struct atomic_file *f)
{
    errno = 0;
    if (ferror(f->out) && f->unfinished && write(fileno(f->out), "", 1) == 1)
        errno = ENOSPC; /* there is room again */
}

bool atomic_file_end(struct atomic_file *f, char **error)
{
    find_reason(f);
    int why = errno;
    if (!close_all(f) || (f->unfinished && rename(f->unfinished, f->path) != 0))
        return fail(f, why ? why : errno ? errno : EIO, error);
    forget(f);
    return true;
}

bool atomic_file_write(const char *path, const void *bytes, size_t size, char **error)
{
    struct atomic_file f;
    if (!atomic_file_begin(&f, path, error))
        return false;
    fwrite(bytes, 1, size, f.out);
    return atomic_file_end(&f, error);
}

void atomic_file_drop(struct atomic_file *f)
{
    close_all(f);
    if (f->unfinished)
        unlink(f->unfinished);
    forget(f);
}

/* A folder that is removed like the file; NULL: none. */
static const char *volatile begun_folder;

/* By another program: a signal's handler may not read a folder. */
static void drop_folder(const char *path)
{
    char *const argv[] = {(char *)(uintptr_t) "rm", (char *)(uintptr_t) "-rf", (char *)(uintptr_t) "--",
                          (char *)(uintptr_t)path, NULL};
    pid_t child = _Fork();
    if (child == 0) {
        execv("/bin/rm", argv);
        _exit(127);
    }
    if (child > 0)
        waitpid(child, NULL, 0);
}

static void drop_and_end(int signal)
{
    if (begun_last)
        unlink(begun_last);
    if (begun_folder)
        drop_folder(begun_folder);
    raise(signal);
}

void atomic_file_drop_folder_at_signals(const char *path)
{
    begun_folder = path;
}

void atomic_file_drop_at_signals(void)
{
    static const int ENDING[] = {SIGINT, SIGTERM, SIGHUP};
    const struct sigaction once = {.sa_handler = drop_and_end, .sa_flags = (int)SA_RESETHAND};
    struct sigaction now;
    for (size_t i = 0; i < sizeof ENDING / sizeof *ENDING; i++)
        if (sigaction(ENDING[i], NULL, &now) == 0 && now.sa_handler != SIG_IGN)
            sigaction(ENDING[i], &once, NULL);
}
