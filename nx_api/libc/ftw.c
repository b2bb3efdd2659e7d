/* ftw.c - the walk through a folder and those in it, in alphabetical order, and in none twice. */
#define _GNU_SOURCE
#include <errno.h>
#include <dirent.h>
#include <ftw.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Either function of the program's. */
struct walk {
    int (*says)(const char *, const struct stat *, int);
    int (*tells)(const char *, const struct stat *, int, struct FTW *);
    int flags;
    dev_t device;
    struct place **visited; /* the last of them; NULL: no link is followed, so no folder comes twice */
};

/* They are a list: how long a search in a tree takes would depend on the host's numbers. */
struct place {
    struct place *before;
    dev_t device;
    ino_t number;
};

/* 1: the folder is visited for the first time; 0: a link has led to it again; -1: there is no memory. */
static int is_new(const struct walk *w, const struct stat *st)
{
    if (!w->visited)
        return 1;
    for (const struct place *p = *w->visited; p; p = p->before)
        if (p->number == st->st_ino && p->device == st->st_dev)
            return 0;
    struct place *place = malloc(sizeof *place);
    if (!place)
        return -1;
    *place = (struct place){*w->visited, st->st_dev, st->st_ino};
    *w->visited = place;
    return 1;
}

static void forget(struct place *visited)
{
    while (visited) {
        struct place *before = visited->before;
        free(visited);
        visited = before;
    }
}

static int tell(const struct walk *w, const char *path, const struct stat *st, int kind, struct FTW *at)
{
    if (w->tells)
        return w->tells(path, st, kind, at);
    return w->says(path, st, kind == FTW_SL || kind == FTW_SLN ? FTW_NS : kind);
}

static int follows(const struct walk *w)
{
    return !w->tells || !(w->flags & FTW_PHYS);
}

static int look(const struct walk *w, const char *path, struct stat *st)
{
    if (follows(w) ? stat(path, st) == 0 : lstat(path, st) == 0)
        return S_ISDIR(st->st_mode) ? FTW_D : S_ISLNK(st->st_mode) ? FTW_SL : FTW_F;
    if (follows(w) && lstat(path, st) == 0 && S_ISLNK(st->st_mode))
        return FTW_SLN;
    return FTW_NS;
}

static int visit(const struct walk *w, const char *path, struct FTW at);

/* Visits what is in a folder. */
static int visit_entries(const struct walk *w, const char *path, DIR *d, struct FTW at)
{
    int answer = 0;
    size_t length = strlen(path);
    for (struct dirent *e; !answer && (e = readdir(d));) {
        if (!strcmp(e->d_name, ".") || !strcmp(e->d_name, ".."))
            continue;
        char *inside = malloc(length + strlen(e->d_name) + 2);
        if (!inside)
            return -1;
        strcpy(inside, path);
        if (length && path[length - 1] != '/')
            strcat(inside, "/");
        struct FTW below = {(int)strlen(inside), at.level + 1};
        answer = visit(w, strcat(inside, e->d_name), below);
        free(inside);
    }
    return answer;
}

static int visit(const struct walk *w, const char *path, struct FTW at)
{
    struct stat st = {0};
    int kind = look(w, path, &st), first = !w->tells || !(w->flags & FTW_DEPTH);
    if (kind == FTW_NS && at.level == 0)
        return -1;
    if (w->tells && w->flags & FTW_MOUNT && kind != FTW_NS && at.level && st.st_dev != w->device)
        return 0;
    if (kind != FTW_D)
        return tell(w, path, &st, kind, &at);
    int new = is_new(w, &st);
    if (new != 1)
        return new;
    DIR *d = opendir(path);
    if (!d)
        return errno == EACCES ? tell(w, path, &st, FTW_DNR, &at) : -1;
    int answer = first ? tell(w, path, &st, FTW_D, &at) : 0;
    if (!answer)
        answer = visit_entries(w, path, d, at);
    closedir(d);
    return answer || first ? answer : tell(w, path, &st, FTW_DP, &at);
}

static int begin(struct walk *w, const char *path)
{
    struct stat st;
    struct place *visited = NULL;
    const char *slash = strrchr(path, '/');
    if (stat(path, &st) == 0)
        w->device = st.st_dev;
    if (follows(w))
        w->visited = &visited;
    int answer = visit(w, path, (struct FTW){slash && slash[1] ? (int)(slash + 1 - path) : 0, 0});
    forget(visited);
    return answer;
}

int ftw(const char *path, int (*function)(const char *, const struct stat *, int), int descriptors)
{
    struct walk w = {.says = function};
    (void)descriptors; /* a folder is read as a whole, and takes none */
    return begin(&w, path);
}

/* FTW_CHDIR is not there: EINVAL. */
int nftw(const char *path, int (*function)(const char *, const struct stat *, int, struct FTW *),
         int descriptors, int flags)
{
    struct walk w = {.tells = function, .flags = flags};
    (void)descriptors;
    if (flags & ~(FTW_PHYS | FTW_MOUNT | FTW_DEPTH)) {
        errno = EINVAL;
        return -1;
    }
    return begin(&w, path);
}

/* By the names of headers with -D_FILE_OFFSET_BITS=64. */
__asm__(".globl ftw64\n.set ftw64, ftw\n.globl nftw64\n.set nftw64, nftw");
