/* names.c - names of temporary files, of the terminal and its user, in memory of the program's own. */
#define _GNU_SOURCE
#include <errno.h>
#include <pwd.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Other ones on each node, and the same in each run unless they are taken. mktemp makes them, so that the
 * program may open them. */
char *tmpnam(char to[L_tmpnam])
{
    static char own[L_tmpnam];
    static int count;
    char name[L_tmpnam];
    snprintf(name, sizeof name, P_tmpdir "/nx%03dXXXXXX", count++ % 1000);
    mktemp(name);
    return *name ? strcpy(to ? to : own, name) : NULL;
}

/* In the folder that the program names: of others it need not know, as it may not write there. */
char *tempnam(const char *folder, const char *begin)
{
    char *name;
    if (asprintf(&name, "%s/%.5sXXXXXX", folder ? folder : P_tmpdir, begin ? begin : "file") < 0)
        return NULL;
    if (*mktemp(name))
        return name;
    free(name);
    return NULL;
}

char *mkdtemp(char *pattern)
{
    return *mktemp(pattern) && mkdir(pattern, 0700) == 0 ? pattern : NULL;
}

#ifndef L_cuserid
#define L_cuserid 9 /* its header has it for X/Open only */
#endif

/* The terminal has none. */
char *ttyname(int fd)
{
    errno = isatty(fd) ? ENODEV : ENOTTY;
    return NULL;
}

char *ctermid(char *to)
{
    static char own[L_ctermid];
    return strcpy(to ? to : own, "/dev/tty");
}

char *cuserid(char *to)
{
    static char own[L_cuserid];
    char *name = to ? to : own;
    snprintf(name, L_cuserid, "%s", getlogin());
    return name;
}

/* There is one user. */
struct passwd *getpwuid(uid_t id)
{
    static struct passwd user;
    char *home = getenv("HOME");
    if (id != getuid())
        return NULL;
    user = (struct passwd){.pw_name = getlogin(),
                           .pw_passwd = "*",
                           .pw_uid = id,
                           .pw_gid = getgid(),
                           .pw_gecos = "",
                           .pw_dir = home ? home : "/",
                           .pw_shell = "/bin/sh"};
    return &user;
}

struct passwd *getpwnam(const char *name)
{
    return strcmp(name, getlogin()) ? NULL : getpwuid(getuid());
}
