/* fence.c - see fence.h. */
#include "guest/libc/fence.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/xalloc.h"

struct entry {
    char *path; /* absolute, without links */
    bool writable;
};

/* A file that a program has looked at. */
struct seen {
    dev_t device; /* this computer's numbers; */
    ino_t number; /* 0: the file is gone */
};

struct fence {
    struct entry *entries;
    size_t count;
    struct seen *seen;
    size_t seen_count;
    char refused[2 * PATH_MAX];
    bool writes, readable; /* of the refusal */
    /* What is being looked up. It is here since it would take a good part of the system's stack. */
    char real[2 * PATH_MAX], folder[PATH_MAX];
};

enum use { LOOKS, READS, WRITES };

/* --- entries --- */

static void add(struct fence *f, const char *path, bool writable)
{
    f->entries = xreallocarray(f->entries, f->count + 1, sizeof *f->entries);
    f->entries[f->count++] = (struct entry){xstrdup(path), writable};
}

struct fence *fence_empty(void)
{
    return xcalloc(1, sizeof(struct fence));
}

struct fence *fence_new(void)
{
    static const char *const devices[] = {"/dev/null", "/dev/zero", "/dev/full"};
    struct fence *f = fence_empty();
    char *here = getcwd(NULL, 0);
    if (here)
        add(f, here, true);
    free(here);
    for (size_t i = 0; i < sizeof devices / sizeof *devices; i++)
        add(f, devices[i], true);
    return f;
}

void fence_free(struct fence *f)
{
    if (!f)
        return;
    for (size_t i = 0; i < f->count; i++)
        free(f->entries[i].path);
    free(f->entries);
    free(f->seen);
    free(f);
}

static bool is_below(const char *path, const char *folder)
{
    size_t n = strlen(folder);
    return strncmp(path, folder, n) == 0 &&
           (path[n] == 0 || path[n] == '/' || (n > 0 && folder[n - 1] == '/'));
}

static bool permits(const struct entry *e, const char *path, enum use use)
{
    if (use == LOOKS && is_below(e->path, path))
        return true; /* on the way to the entry */
    return is_below(path, e->path) && (use != WRITES || e->writable);
}

/* 0, or FENCE_REFUSED. path is absolute and without links. */
static int check(struct fence *f, const char *path, enum use use)
{
    f->readable = false;
    for (size_t i = 0; i < f->count; i++)
        if (permits(&f->entries[i], path, use))
            return 0;
        else
            f->readable |= is_below(path, f->entries[i].path);
    snprintf(f->refused, sizeof f->refused, "%s", path);
    f->writes = use == WRITES;
    return FENCE_REFUSED;
}

struct fence_refusal fence_refusal(const struct fence *f)
{
    return (struct fence_refusal){f->refused, f->writes, f->readable};
}

/* --- numbers: this computer's own are others in each run. A program sees them even if it never asks, in
 * memory that it has not set, as GNU Fortran's library keeps those of open files. --- */

static size_t place_of(const struct fence *f, const struct stat *st)
{
    size_t i = 0;
    while (i < f->seen_count && (f->seen[i].number != st->st_ino || f->seen[i].device != st->st_dev))
        i++;
    return i;
}

/* Numbers files in the order in which programs first look at them. */
static int numbered(struct fence *f, struct stat *st, int answer)
{
    if (answer)
        return answer;
    size_t i = place_of(f, st);
    if (i == f->seen_count) {
        f->seen = xreallocarray(f->seen, ++f->seen_count, sizeof *f->seen);
        f->seen[i] = (struct seen){st->st_dev, st->st_ino};
    }
    st->st_dev = 1;
    st->st_ino = i + 1;
    return 0;
}

/* Where the file that has the name is among those seen. */
static size_t place_of_named(const struct fence *f, int folder, const char *name)
{
    struct stat st;
    return fstatat(folder, name, &st, AT_SYMLINK_NOFOLLOW) ? f->seen_count : place_of(f, &st);
}

/* A name was removed, unless the answer is an error: this computer may give the file's number to another. */
static int forgotten(struct fence *f, size_t i, int answer)
{
    if (!answer && i < f->seen_count)
        f->seen[i].number = 0;
    return answer;
}

int fence_fstat(struct fence *f, int fd, struct stat *st)
{
    return f ? numbered(f, st, fstat(fd, st)) : fstat(fd, st);
}

/* --- looking up --- */

/* The name that the kernel has for an open descriptor, also for one that only names a file. */
struct own_name {
    char text[64];
};

static struct own_name name_of(int fd)
{
    struct own_name n;
    snprintf(n.text, sizeof n.text, "/proc/self/fd/%d", fd);
    return n;
}

/* The path of the file open as fd. A name that the kernel does not know, as that of a pipe, is no absolute
 * path, and so outside of each fence. */
static bool path_of(int fd, char path[PATH_MAX])
{
    ssize_t n = readlink(name_of(fd).text, path, PATH_MAX - 1);
    if (n < 0)
        return false;
    path[n] = 0;
    return true;
}

/* Closes fd. Keeps errno. */
static int closed(int fd, int answer)
{
    int why = errno;
    close(fd);
    errno = why;
    return answer;
}

/* A node has no such files: what they tell is of this computer. Programs look there (is there a debugger? how
 * much memory?) and do without. */
static bool is_of_this_kernel(const char *path)
{
    return is_below(path, "/proc") || is_below(path, "/sys");
}

/* Looks a file up without opening it. Returns a descriptor for it, -1 or FENCE_REFUSED. */
static int look_up(struct fence *f, const char *path, int flags, enum use use)
{
    int fd = open(path, O_PATH | O_CLOEXEC | flags);
    if (fd < 0)
        return -1;
    if (!path_of(fd, f->real))
        return closed(fd, -1);
    int answer = check(f, f->real, use);
    if (answer && is_of_this_kernel(f->real)) {
        errno = ENOENT;
        answer = -1;
    }
    return answer ? closed(fd, answer) : fd;
}

/* A name in a folder, for what is not there yet, or is to be removed. */
struct place {
    int folder;
    char name[NAME_MAX + 1];
};

static bool split(const char *path, char folder[PATH_MAX], char name[NAME_MAX + 1])
{
    size_t end = strlen(path);
    while (end > 1 && path[end - 1] == '/')
        end--;
    size_t begin = end;
    while (begin > 0 && path[begin - 1] != '/')
        begin--;
    errno = end == 0 ? ENOENT : end - begin > NAME_MAX || begin >= PATH_MAX ? ENAMETOOLONG : EINVAL;
    if (end == begin || end - begin > NAME_MAX || begin >= PATH_MAX)
        return false;
    snprintf(folder, PATH_MAX, "%.*s", begin ? (int)begin : 1, begin ? path : ".");
    snprintf(name, NAME_MAX + 1, "%.*s", (int)(end - begin), path + begin);
    return strcmp(name, ".") != 0 && strcmp(name, "..") != 0;
}

/* Looks up the folder of a name, and sets f->real to the path of what has, or will have, the name. The
 * place's folder is to be closed unless the answer is -1. */
static int find_place(struct fence *f, const char *path, struct place *p)
{
    if (!split(path, f->folder, p->name))
        return -1;
    p->folder = open(f->folder, O_PATH | O_DIRECTORY | O_CLOEXEC);
    if (p->folder < 0)
        return -1;
    if (!path_of(p->folder, f->folder))
        return closed(p->folder, -1);
    snprintf(f->real, sizeof f->real, "%s/%s", strcmp(f->folder, "/") ? f->folder : "", p->name);
    return 0;
}

/* Finds a place where the program may write. Also answers FENCE_REFUSED. */
static int look_up_place(struct fence *f, const char *path, struct place *p)
{
    if (find_place(f, path, p))
        return -1;
    int answer = check(f, f->real, WRITES);
    return answer ? closed(p->folder, answer) : 0;
}

bool fence_add(struct fence *f, const char *path, bool writable)
{
    struct place p;
    char *real = realpath(path, NULL);
    if (real) {
        add(f, real, writable);
        free(real);
        return true;
    }
    if (errno != ENOENT || find_place(f, path, &p))
        return false;
    close(p.folder);
    add(f, f->real, writable);
    return true;
}

/* --- opening --- */

static enum use use_of(int flags)
{
    return (flags & O_ACCMODE) != O_RDONLY || flags & (O_CREAT | O_TRUNC) ? WRITES : READS;
}

/* Opens a file that has been looked up. */
static int open_found(int fd, int flags)
{
    struct stat st;
    if ((flags & O_CREAT) && (flags & O_EXCL)) {
        errno = EEXIST;
        return -1;
    }
    if (fstat(fd, &st) == 0 && S_ISLNK(st.st_mode)) {
        errno = ELOOP; /* the program asked for no link */
        return -1;
    }
    return open(name_of(fd).text, flags & ~(O_CREAT | O_NOFOLLOW));
}

int fence_open(struct fence *f, const char *path, int flags, mode_t permissions)
{
    struct place p;
    if (!f)
        return open(path, flags, permissions);
    int fd = look_up(f, path, flags & O_NOFOLLOW, use_of(flags));
    if (fd >= 0)
        return closed(fd, open_found(fd, flags));
    if (fd == FENCE_REFUSED || errno != ENOENT || !(flags & O_CREAT))
        return fd;
    if (*path && path[strlen(path) - 1] == '/') {
        errno = EISDIR; /* a folder's name, which no file gets */
        return -1;
    }
    int answer = look_up_place(f, path, &p);
    return answer ? answer : closed(p.folder, openat(p.folder, p.name, flags | O_NOFOLLOW, permissions));
}

/* Is the path, without links, that of a file in the folder? */
static bool is_in(const char *path, const char *folder)
{
    char *real = folder ? realpath(folder, NULL) : NULL;
    bool in = real && is_below(path, real) && strrchr(path, '/') == path + strlen(real);
    free(real);
    return in;
}

int fence_open_temporary(struct fence *f, const char *path, int flags)
{
    struct place p;
    if (!f)
        return open(path, flags | O_CREAT | O_EXCL, 0600);
    if (find_place(f, path, &p))
        return -1;
    bool temporary = is_in(f->real, P_tmpdir) || is_in(f->real, getenv("TMPDIR"));
    if (!temporary && check(f, f->real, WRITES))
        return closed(p.folder, FENCE_REFUSED);
    int fd = openat(p.folder, p.name, flags | O_CREAT | O_EXCL | O_NOFOLLOW, 0600);
    if (fd >= 0 && temporary && check(f, f->real, WRITES)) /* else an earlier file of that name is noted */
        add(f, f->real, true);
    return closed(p.folder, fd);
}

/* --- names --- */

static int stat_found(struct fence *f, const char *path, struct stat *st, int flags)
{
    int fd = look_up(f, path, flags, LOOKS);
    return fd < 0 ? fd : closed(fd, fence_fstat(f, fd, st));
}

int fence_stat(struct fence *f, const char *path, struct stat *st)
{
    return f ? stat_found(f, path, st, 0) : stat(path, st);
}

int fence_lstat(struct fence *f, const char *path, struct stat *st)
{
    return f ? stat_found(f, path, st, O_NOFOLLOW) : lstat(path, st);
}

ssize_t fence_readlink(struct fence *f, const char *path, char *buf, size_t size)
{
    if (!f)
        return readlink(path, buf, size);
    int fd = look_up(f, path, O_NOFOLLOW, LOOKS);
    struct stat st;
    if (fd < 0)
        return fd;
    if (fstat(fd, &st) == 0 && S_ISLNK(st.st_mode))
        return closed(fd, (int)readlinkat(fd, "", buf, size));
    errno = EINVAL;
    return closed(fd, -1);
}

int fence_chmod(struct fence *f, const char *path, mode_t permissions)
{
    if (!f)
        return chmod(path, permissions);
    int fd = look_up(f, path, 0, WRITES);
    return fd < 0 ? fd : closed(fd, chmod(name_of(fd).text, permissions));
}

int fence_utimes(struct fence *f, const char *path, const struct timeval times[2])
{
    if (!f)
        return utimes(path, times);
    int fd = look_up(f, path, 0, WRITES);
    return fd < 0 ? fd : closed(fd, utimes(name_of(fd).text, times));
}

static int remove_at(struct fence *f, const char *path, int flags)
{
    struct place p;
    int answer = look_up_place(f, path, &p);
    if (answer)
        return answer;
    size_t i = place_of_named(f, p.folder, p.name);
    return closed(p.folder, forgotten(f, i, unlinkat(p.folder, p.name, flags)));
}

int fence_unlink(struct fence *f, const char *path)
{
    return f ? remove_at(f, path, 0) : unlink(path);
}

int fence_rmdir(struct fence *f, const char *path)
{
    return f ? remove_at(f, path, AT_REMOVEDIR) : rmdir(path);
}

int fence_mkdir(struct fence *f, const char *path, mode_t permissions)
{
    struct place p;
    if (!f)
        return mkdir(path, permissions);
    int answer = look_up_place(f, path, &p);
    return answer ? answer : closed(p.folder, mkdirat(p.folder, p.name, permissions));
}

int fence_rename(struct fence *f, const char *from, const char *to)
{
    struct place old, new;
    if (!f)
        return rename(from, to);
    int answer = look_up_place(f, from, &old);
    if (answer)
        return answer;
    answer = look_up_place(f, to, &new);
    if (answer)
        return closed(old.folder, answer);
    size_t i = place_of_named(f, new.folder, new.name);
    answer = forgotten(f, i, renameat(old.folder, old.name, new.folder, new.name));
    return closed(old.folder, closed(new.folder, answer));
}
