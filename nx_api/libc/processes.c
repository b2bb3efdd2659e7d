/* processes.c - other processes, users and groups, of which a program learns that a node has one each; and
 * its processor. */
#define _GNU_SOURCE
#include <errno.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <sys/wait.h>
#include <unistd.h>

static int no_child(void)
{
    errno = ECHILD;
    return -1;
}

pid_t wait(int *status)
{
    (void)status;
    return no_child();
}

pid_t waitpid(pid_t process, int *status, int options)
{
    (void)process, (void)status, (void)options;
    return no_child();
}

/* A program may become what it is. */
static int become(int is_so)
{
    if (is_so)
        return 0;
    errno = EPERM;
    return -1;
}

int setuid(uid_t id)
{
    return become(id == getuid());
}

int seteuid(uid_t id)
{
    return become(id == getuid());
}

int setgid(gid_t id)
{
    return become(id == getgid());
}

int setegid(gid_t id)
{
    return become(id == getgid());
}

int getgroups(int room, gid_t *to)
{
    if (room > 0)
        *to = getgid();
    return 1;
}

pid_t setsid(void)
{
    return getpid();
}

pid_t getsid(pid_t process)
{
    (void)process;
    return getpid();
}

pid_t getpgid(pid_t process)
{
    (void)process;
    return getpid();
}

int setpgid(pid_t process, pid_t group)
{
    (void)process, (void)group;
    return 0;
}

int getpriority(__priority_which_t which, id_t who)
{
    (void)which, (void)who;
    return 0;
}

int setpriority(__priority_which_t which, id_t who, int to)
{
    (void)which, (void)who, (void)to;
    return 0;
}

int sched_yield(void)
{
    return 0;
}

int get_nprocs(void)
{
    return 1;
}

int get_nprocs_conf(void)
{
    return 1;
}

void psignal(int number, const char *text)
{
    int named = text && *text;
    fprintf(stderr, "%s%s%s\n", named ? text : "", named ? ": " : "", strsignal(number));
}
