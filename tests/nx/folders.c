/* Folders are read by name, whatever the computer's own order, and walked through: of this computer and of
 * the CFS; and paths lose their links.
 * simulator only: a cluster keeps its folders in its own order
 * compile: -D_GNU_SOURCE
 * again: --long32
 * run: all
 */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <glob.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "rule.h"

static char top[60], seen[400];

static void make(const char *folder, const char *name)
{
    char path[200];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    close(creat(path, 0600));
}

/* The names of what readdir finds, from "." on. */
static const char *names(DIR *d)
{
    *seen = 0;
    for (struct dirent *e; (e = readdir(d));) {
        strcat(strcat(seen, e->d_name), e->d_type == DT_DIR ? "/ " : " ");
        if (e->d_ino == 0)
            return "no number";
    }
    return seen;
}

static int read_in_order(const char *folder)
{
    static const char *const all[] = {"beta", "alpha", "Gamma", "a.c", "10", "9", "folder/inside"};
    for (int i = 0; i < 7; i++)
        make(folder, all[i]);
    DIR *d = opendir(folder);
    int good = d && !strcmp(names(d), "./ ../ 10 9 Gamma a.c alpha beta folder/ ");
    make(folder, "Z");
    good = good && !readdir(d);
    rewinddir(d);
    good = good && !strcmp(names(d), "./ ../ 10 9 Gamma Z a.c alpha beta folder/ ");
    return good && closedir(d) == 0;
}

static int places(void)
{
    DIR *d = opendir(top);
    char third[20];
    readdir(d), readdir(d);
    long at = telldir(d);
    strcpy(third, readdir(d)->d_name);
    readdir(d);
    seekdir(d, at);
    return !strcmp(readdir(d)->d_name, third) && closedir(d) == 0;
}

static int is_c(const struct dirent *e)
{
    const char *dot = strrchr(e->d_name, '.');
    return dot && !strcmp(dot, ".c");
}

static int backwards(const struct dirent **a, const struct dirent **b)
{
    return -alphasort(a, b);
}

static int selected(void)
{
    struct dirent **list;
    int count = scandir(top, &list, is_c, alphasort), good = count == 1 && !strcmp(list[0]->d_name, "a.c");
    free(list[0]), free(list);
    count = scandir(top, &list, NULL, backwards);
    good = good && count == 10 && !strcmp(list[0]->d_name, "folder") && !strcmp(list[9]->d_name, ".");
    for (int i = 0; i < count; i++)
        free(list[i]);
    free(list);
    return good && scandir("nowhere", &list, NULL, NULL) == -1 && errno == ENOENT;
}

static int errors(void)
{
    char path[100];
    snprintf(path, sizeof path, "%s/beta", top);
    errno = 0;
    int good = !opendir("nowhere") && errno == ENOENT && !opendir("") && errno == ENOENT;
    return good && !opendir(path) && errno == ENOTDIR;
}

static int depth, kinds[8];

static int visit(const char *path, const struct stat *st, int kind, struct FTW *at)
{
    strcat(strcat(seen, path + at->base), " ");
    kinds[kind]++;
    if (at->level > depth)
        depth = at->level;
    return kind == FTW_F && st->st_size > 0;
}

static int visit_old(const char *path, const struct stat *st, int kind)
{
    return kind == FTW_F && !S_ISDIR(st->st_mode) && strstr(path, "folder/inside") ? 7 : 0;
}

static int walked(void)
{
    char expected[200];
    *seen = 0;
    int good = nftw(top, visit, 10, FTW_PHYS) == 0 && kinds[FTW_F] == 8 && kinds[FTW_D] == 2 && depth == 2;
    snprintf(expected, sizeof expected, "%s 10 9 Gamma Z a.c alpha beta folder inside ", top);
    good = good && !strcmp(seen, expected) && ftw(top, visit_old, 10) == 7;
    *seen = 0;
    good = good && nftw(top, visit, 10, FTW_DEPTH) == 0 && kinds[FTW_DP] == 2;
    snprintf(expected, sizeof expected, "10 9 Gamma Z a.c alpha beta inside folder %s ", top);
    return good && !strcmp(seen, expected);
}

static int by_patterns(void)
{
    char pattern[100];
    glob_t g = {.gl_offs = 1};
    snprintf(pattern, sizeof pattern, "%s/[a-z]*", top);
    int good = glob(pattern, GLOB_MARK | GLOB_DOOFFS, NULL, &g) == 0 && g.gl_pathc == 4 && !g.gl_pathv[0];
    good = good && strstr(g.gl_pathv[1], "/a.c") && strstr(g.gl_pathv[4], "/folder/") && !g.gl_pathv[5];
    snprintf(pattern, sizeof pattern, "%s/*/in?ide", top);
    good = good && glob(pattern, GLOB_MARK | GLOB_DOOFFS | GLOB_APPEND, NULL, &g) == 0 && g.gl_pathc == 5;
    globfree(&g);
    snprintf(pattern, sizeof pattern, "%s/no*where",
             top); /* (what else is in the current folder takes time) */
    return good && glob("nowhere/*", 0, NULL, &g) == GLOB_NOMATCH &&
           glob(pattern, GLOB_NOCHECK, NULL, &g) == 0 && !strcmp(g.gl_pathv[0], pattern);
}

static int without_links(void)
{
    char path[200], whole[PATH_MAX], text[10], *real;
    snprintf(path, sizeof path, "%s/./folder/..//beta", top);
    int good = (real = realpath(path, NULL)) && getcwd(whole, sizeof whole);
    strcat(strcat(strcat(whole, "/"), top), "/beta");
    good = good && !strcmp(real, whole) && real[0] == '/';
    free(real);
    errno = 0;
    good = good && !realpath("nowhere", NULL) && errno == ENOENT;
    snprintf(path, sizeof path, "%s/beta/x", top);
    good = good && !realpath(path, NULL) && errno == ENOTDIR;
    errno = 0;
    return good && readlink(top, text, sizeof text) == -1 && errno == EINVAL;
}

static void remove_all(void)
{
    static const char *const all[] = {"beta", "alpha", "Gamma",         "a.c",   "10",
                                      "9",    "Z",     "folder/inside", "folder"};
    char path[200];
    for (int i = 0; i < 9; i++) {
        snprintf(path, sizeof path, "%s/%s", top, all[i]);
        remove(path);
    }
    rmdir(top);
}

/* In the CFS files make their folders; each node has one, and node 0 finds them all. */
static int of_the_cfs(void)
{
    char folder[60], name[80];
    struct stat st;
    DIR *d;
    snprintf(folder, sizeof folder, "/cfs/folders/%02ld", mynode());
    snprintf(name, sizeof name, "%s/folder", folder);
    if (stat("/cfs", &st) < 0)
        return -1;
    int good = !opendir(folder) && errno == ENOENT && read_in_order(folder);
    gsync();
    d = opendir("/cfs/folders");
    good = good && d && strlen(names(d)) == 7 + 4 * (size_t)numnodes() && strstr(seen, "../ 00/ ");
    closedir(d);
    gsync();
    return good && chdir("/cfs") == 0 && (d = opendir("folders/00")) && closedir(d) == 0;
}

int main(void)
{
    snprintf(top, sizeof top, "folders.tmp%ld", mynode());
    mkdir(top, 0700);
    char inside[80];
    snprintf(inside, sizeof inside, "%s/folder", top);
    mkdir(inside, 0700);
    rule("opendir, readdir, rewinddir", read_in_order(top));
    rule("telldir, seekdir", places());
    rule("scandir", selected());
    rule("what is no folder", errors());
    rule("ftw, nftw", walked());
    rule("glob", by_patterns());
    rule("realpath, readlink", without_links());
    remove_all();
    rule("folders of the CFS", of_the_cfs());
    return 0;
}
