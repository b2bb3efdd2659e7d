/* processes.c - what a program asks of other processes, of which a node has none, and of its processor. */
#define _GNU_SOURCE
#include <errno.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
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
