/* overdue.c - see overdue.h. */
#include "machine/overdue.h"
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>
#include "kernel/hostclock.h"
#include "machine/crash.h"
#include "machine/outside.h"

/* Seconds of host time: how late a run may end, and from one look to the next. */
static const double PATIENCE = 1;
static const struct timespec EVERY = {.tv_nsec = 500000000};

/* What the handler looks at: the machine that runs, its timer, and when its end will be overdue. */
static struct machine *running;
static timer_t timer;
static _Atomic double overdue_at;

static void end_at_once(int signal)
{
    static const char TEXT[] = "touchstone run: ended at once, by a second signal\n";
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, signal);
    (void)!write(STDERR_FILENO, TEXT, sizeof TEXT - 1);
    sigaction(signal, &(struct sigaction){.sa_handler = SIG_DFL}, NULL);
    pthread_sigmask(SIG_UNBLOCK, &one, NULL);
    raise(signal);
}

/* Of two signals within a second, as `timeout` sends them, the later one is none. */
static void on_tick(int signal, siginfo_t *info, void *context)
{
    int saved = errno;
    bool late = hostclock_s() > overdue_at;
    if (late)
        crash_end_computing(signal, info, context);
    if (info->si_code == SI_TIMER) {
        bool asked = running->signal;
        int ending = outside_take_ending(running);
        if (ending && asked && late)
            end_at_once(ending);
    }
    errno = saved;
}

void overdue_begin(struct machine *m)
{
    struct sigaction a = {.sa_sigaction = on_tick,
                          .sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER | SA_RESTART};
    struct sigevent mine = {
        .sigev_notify = SIGEV_THREAD_ID, .sigev_signo = SIGALRM, ._sigev_un._tid = gettid()};
    struct itimerspec often = {EVERY, EVERY};
    double limit = m->options.max_wall_s;
    if (m->sys.debugger || timer_create(CLOCK_MONOTONIC, &mine, &timer))
        return;
    running = m;
    overdue_at = limit > 0 ? m->begin + limit + PATIENCE : INFINITY;
    sigaction(SIGALRM, &a, NULL);
    timer_settime(timer, 0, &often, NULL);
}

void overdue_end(void)
{
    if (running)
        timer_delete(timer);
    running = NULL;
}

void overdue_from_now(void)
{
    overdue_at = fmin(overdue_at, hostclock_s() + PATIENCE);
}

void overdue_hurry(pthread_t thread)
{
    if (running)
        pthread_kill(thread, SIGALRM);
}
