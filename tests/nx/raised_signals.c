/* raised_signals.c - handlers of signals that the program raises itself: as signal, sigaction and System V's
 * sigset set them, left by siglongjmp, and each node's its own.
 * simulator only: signals of a cluster's processes are its computers'
 * compile: -Wno-deprecated-declarations
 * run: all
 */
#define _GNU_SOURCE
#include <assert.h>
#include <errno.h>
#include <nx.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static volatile int calls, last, sender;
static sigjmp_buf back;

static void count(int number)
{
    calls++;
    last = number;
}

static void count_more(int number, siginfo_t *info, void *context)
{
    (void)context;
    count(number);
    sender = info->si_signo == number ? (int)info->si_pid : -1;
}

static void leave(int number)
{
    siglongjmp(back, number);
}

static int is_called(int number)
{
    int before = calls;
    return raise(number) == 0 && calls == before + 1 && last == number;
}

static int left_by_jumps(void)
{
    volatile int jumps = 0;
    signal(SIGBUS, leave);
    if (sigsetjmp(back, 1))
        jumps++;
    if (jumps < 5)
        raise(SIGBUS);
    return jumps;
}

static int aborts(void)
{
    volatile int jumps = 0;
    signal(SIGABRT, leave);
    if (sigsetjmp(back, 1))
        jumps++;
    if (jumps < 2)
        abort();
    assert(jumps == 4 || ++jumps == 0);
    return jumps;
}

static void check(const char *what, int good)
{
    if (!good)
        printf("node %ld: %s: NO\n", mynode(), what);
}

int main(void)
{
    struct sigaction once = {.sa_sigaction = count_more, .sa_flags = SA_SIGINFO | SA_RESETHAND}, now;
    check("signal", signal(SIGUSR1, count) == SIG_DFL && is_called(SIGUSR1) && is_called(SIGUSR1));
    check("ignored", signal(SIGUSR1, SIG_IGN) == count && raise(SIGUSR1) == 0);
    check("the default again", signal(SIGUSR1, SIG_DFL) == SIG_IGN && raise(SIGCHLD) == 0);
    check("sigaction", sigaction(SIGFPE, &once, NULL) == 0 && is_called(SIGFPE) && sender == getpid());
    check("called once", sigaction(SIGFPE, NULL, &now) == 0 && now.sa_handler == SIG_DFL);
    check("siglongjmp", left_by_jumps() == 5);
    check("abort, assert", aborts() == 4);
    check("sigset", sigset(SIGUSR2, count) == SIG_DFL && is_called(SIGUSR2));
    check("sigignore", sigignore(SIGUSR2) == 0 && raise(SIGUSR2) == 0);
    check("kill",
          signal(SIGUSR1, count) == SIG_DFL && kill(getpid(), SIGUSR1) == 0 && kill(getpid(), 0) == 0);
    char room[16384];
    stack_t own = {.ss_sp = room, .ss_size = sizeof room}, small = {.ss_sp = room, .ss_size = 100}, found;
    check("no stack of handlers", sigaltstack(&own, &found) == 0 && found.ss_flags == SS_DISABLE);
    check("a stack of handlers",
          sigaltstack(NULL, &found) == 0 && found.ss_sp == room && found.ss_flags == 0);
    check("usual sizes", SIGSTKSZ >= MINSIGSTKSZ && MINSIGSTKSZ > 100);
    check("too small", sigaltstack(&small, NULL) == -1 && errno == ENOMEM);
    check("how often", calls == 5);
    check("no signal", raise(0) == 0 && raise(-1) == -1 && errno == EINVAL && signal(0, count) == SIG_ERR);
    check("not to be handled", signal(SIGKILL, count) == SIG_ERR && signal(SIGSTOP, SIG_IGN) == SIG_ERR);
    if (mynode() == 0) /* no other node has it */
        signal(SIGTERM, count);
    gsync();
    check("each node's own", signal(SIGTERM, SIG_IGN) == (mynode() == 0 ? count : SIG_DFL));
    if (mynode() == 0)
        printf("handlers of raised signals were called\n");
    return 0;
}
