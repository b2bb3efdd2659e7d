/* socket.c - see socket.h. */
#include "srm/socket.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>
#include "kernel/xalloc.h"

/* The folder of the socket where there is no $XDG_RUNTIME_DIR. */
static void default_folder(char folder[SOCKET_PATH])
{
    snprintf(folder, SOCKET_PATH, "/tmp/touchstone-%u", (unsigned)getuid());
}

/* Anybody can make a folder in /tmp: it must belong to this user, and be closed to others. */
static char *own_folder(const char *path, bool to_listen)
{
    struct stat st;
    if (to_listen && mkdir(path, 0700) && errno != EEXIST)
        return xasprintf("%s cannot be made: %m", path);
    if (!to_listen && access(path, F_OK) != 0)
        return NULL; /* no service has listened there */
    if (lstat(path, &st) || !S_ISDIR(st.st_mode) || st.st_uid != getuid() || st.st_mode & 077)
        return xasprintf(
            "%s is not a folder of yours that is closed to others (mode 0700): remove it, or give --socket",
            path);
    return NULL;
}

char *socket_path(const char *given, bool to_listen, char path[SOCKET_PATH])
{
    const char *named = getenv("TOUCHSTONE_SRM"), *runtime = getenv("XDG_RUNTIME_DIR");
    char *error = NULL;
    int n;
    if (given || (named && *named)) {
        n = snprintf(path, SOCKET_PATH, "%s", given ? given : named);
    } else if (runtime && *runtime) {
        n = snprintf(path, SOCKET_PATH, "%s/touchstone-srm", runtime);
    } else {
        default_folder(path);
        error = own_folder(path, to_listen);
        n = (int)strlen(strcat(path, "/srm"));
    }
    if (error || (n > 0 && n < SOCKET_PATH))
        return error;
    return xasprintf("the path of a socket has 1 to %d characters", SOCKET_PATH - 1);
}

static struct sockaddr_un address(const char *path)
{
    struct sockaddr_un a = {.sun_family = AF_UNIX};
    memcpy(a.sun_path, path, strlen(path));
    return a;
}

/* Locks PATH.lock, in which its holder has written its process number. */
static char *take_lock(const char *path, int *lock)
{
    char name[SOCKET_PATH + 8], number[16] = "";
    snprintf(name, sizeof name, "%s.lock", path);
    *lock = open(name, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (*lock < 0)
        return xasprintf("%s cannot be opened: %m", name);
    if (flock(*lock, LOCK_EX | LOCK_NB) == 0)
        return NULL;
    ssize_t n = pread(*lock, number, sizeof number - 1, 0);
    close(*lock);
    return xasprintf("a service runs at %s already%s%.*s: stop it, or give another --socket", path,
                     n > 0 ? ", process " : "", n > 0 ? (int)strcspn(number, "\n") : 0, number);
}

char *socket_listen(const char *path, int *fd, int *lock)
{
    struct sockaddr_un a = address(path);
    struct stat st;
    char *error = take_lock(path, lock);
    if (error)
        return error;
    if (lstat(path, &st) == 0 && !S_ISSOCK(st.st_mode)) {
        close(*lock);
        return xasprintf("%s is there, and is no socket: give another --socket", path);
    }
    unlink(path);
    mode_t before = umask(0177);
    *fd = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    bool bound = *fd >= 0 && bind(*fd, (struct sockaddr *)&a, sizeof a) == 0 && listen(*fd, 64) == 0;
    umask(before);
    if (bound)
        return NULL;
    error = xasprintf("%s cannot be listened at: %m", path);
    close(*fd);
    close(*lock);
    return error;
}

void socket_owner(int lock)
{
    if (ftruncate(lock, 0) == 0)
        dprintf(lock, "%d\n", (int)getpid());
}

void socket_remove(const char *path)
{
    char name[SOCKET_PATH + 8], folder[SOCKET_PATH];
    snprintf(name, sizeof name, "%s.lock", path);
    unlink(path);
    unlink(name);
    default_folder(folder);
    if (strncmp(path, folder, strlen(folder)) == 0 && path[strlen(folder)] == '/')
        rmdir(folder); /* unless it has more */
}

char *socket_connect(const char *path, int *fd)
{
    struct sockaddr_un a = address(path);
    *fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (*fd >= 0 && connect(*fd, (struct sockaddr *)&a, sizeof a) == 0)
        return NULL;
    char *error =
        xasprintf("no service answers at %s (%m): touchstone srm --machine ipsc860 -d starts one", path);
    close(*fd);
    return error;
}
