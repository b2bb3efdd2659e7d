/* signal_handlers.c - the handlers of signals, which a program calls that raises a signal itself, or aborts.
 * No other signal comes to a node; what is blocked changes nothing. */
#define _GNU_SOURCE
#include <errno.h>
#include <signal.h>
#include <stddef.h>
#include <unistd.h>

/* The system's: */
_Noreturn void nx_ends_by(int number);  /* what a signal without a handler does */
void nx_at_abort(void (*f)(void));      /* what abort(3) calls first */
int nx_kill(pid_t process, int number); /* to all processes of the program */

static struct sigaction actions[NSIG]; /* all SIG_DFL */

static int may_be_handled(int number)
{
    if (number > 0 && number < NSIG && number != SIGKILL && number != SIGSTOP)
        return 1;
    errno = EINVAL;
    return 0;
}

static void aborts(void)
{
    if (actions[SIGABRT].sa_handler != SIG_DFL)
        raise(SIGABRT);
}

int sigaction(int number, const struct sigaction *to, struct sigaction *before)
{
    if (!may_be_handled(number))
        return -1;
    struct sigaction was = actions[number];
    if (to && number == SIGABRT)
        nx_at_abort(aborts);
    if (to)
        actions[number] = *to;
    if (before)
        *before = was;
    return 0;
}

/* Handlers run on the stack of the program that raises the signal, whatever it says here. */
int sigaltstack(const stack_t *to, stack_t *before)
{
    static stack_t stack = {.ss_flags = SS_DISABLE};
    stack_t was = stack;
    if (to && !(to->ss_flags & SS_DISABLE) && to->ss_size < (size_t)MINSIGSTKSZ) {
        errno = ENOMEM;
        return -1;
    }
    if (to)
        stack = *to;
    if (before)
        *before = was;
    return 0;
}

static sighandler_t handle(int number, sighandler_t handler, int flags)
{
    struct sigaction was;
    if (sigaction(number, &(struct sigaction){.sa_handler = handler, .sa_flags = flags}, &was))
        return SIG_ERR;
    return was.sa_handler;
}

sighandler_t signal(int number, sighandler_t handler)
{
    return handle(number, handler, SA_RESTART);
}

/* As signal(), for programs compiled with -std=c90: the handler is called once. */
sighandler_t __sysv_signal(int number, sighandler_t handler)
{
    return handle(number, handler, SA_RESETHAND | SA_NODEFER);
}

/* System V's. */
sighandler_t sigset(int number, sighandler_t handler)
{
    if (handler == SIG_HOLD)
        return may_be_handled(number) ? actions[number].sa_handler : SIG_ERR;
    return handle(number, handler, 0);
}

int sigignore(int number)
{
    return handle(number, SIG_IGN, 0) == SIG_ERR ? -1 : 0;
}

static int is_ignored(int number, const struct sigaction *a)
{
    return a->sa_handler == SIG_IGN || (a->sa_handler == SIG_DFL && (number == SIGCHLD || number == SIGCONT ||
                                                                     number == SIGURG || number == SIGWINCH));
}

int raise(int number)
{
    if (number < 0 || number >= NSIG) {
        errno = EINVAL;
        return -1;
    }
    struct sigaction a = actions[number];
    if (number == 0 || is_ignored(number, &a))
        return 0;
    if (a.sa_handler == SIG_DFL)
        nx_ends_by(number);
    if (a.sa_flags & SA_RESETHAND)
        actions[number] = (struct sigaction){.sa_handler = SIG_DFL};
    if (a.sa_flags & SA_SIGINFO) {
        siginfo_t info = {.si_signo = number, .si_code = SI_TKILL};
        info.si_pid = getpid();
        info.si_uid = getuid();
        a.sa_sigaction(number, &info, NULL);
    } else {
        a.sa_handler(number);
    }
    return 0;
}

int kill(pid_t process, int number)
{
    return process > 0 && process == getpid() ? raise(number) : nx_kill(process, number);
}
