/* turn_thread.c - see turn_thread.h. */
#include "kernel/turn_thread.h"
#include <errno.h>
#include <linux/futex.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <unistd.h>
#include "kernel/xalloc.h"

enum { STACK_BYTES = 1 << 18 };

struct turn_thread {
    struct turn_thread_calls calls;
    pthread_t id;
    atomic_uint turn, back; /* 1: it is the thread's turn; the giver's again */
    int carried;            /* errno, from one to the other */
    bool interruptible;     /* the giver takes SIGINT */
    bool over;              /* run() is to return */
    void (*asked)(void *arg);
    void *asked_arg;
};

/* (Not by the C library's semaphores: a debugger would show six calls for each thread that waits.) */
static void take(atomic_uint *word)
{
    while (!atomic_exchange(word, 0))
        syscall(SYS_futex, word, FUTEX_WAIT_PRIVATE, 0, NULL, NULL, 0);
}

static void post(atomic_uint *word)
{
    atomic_store(word, 1);
    syscall(SYS_futex, word, FUTEX_WAKE_PRIVATE, 1, NULL, NULL, 0);
}

/* Blocks or unblocks SIGINT; returns whether it was unblocked. */
static bool interrupts(int how)
{
    sigset_t one, before;
    sigemptyset(&one);
    sigaddset(&one, SIGINT);
    pthread_sigmask(how, &one, &before);
    return !sigismember(&before, SIGINT);
}

static void hand_over(struct turn_thread *t, atomic_uint *to)
{
    t->carried = errno;
    post(to);
}

/* Waits for the turn; answers turn_thread_call() meanwhile. */
static void await_turn(struct turn_thread *t)
{
    for (take(&t->turn); t->asked; take(&t->turn)) {
        t->asked(t->asked_arg);
        t->asked = NULL;
        post(&t->back);
    }
    if (t->interruptible)
        interrupts(SIG_UNBLOCK);
    errno = t->carried;
}

static void *live(void *arg)
{
    struct turn_thread *t = arg;
    void *own = t->calls.begin();
    await_turn(t);
    if (!t->over)
        t->calls.run(t->calls.arg);
    if (!t->over) { /* finished by itself */
        interrupts(SIG_BLOCK);
        hand_over(t, &t->back);
        await_turn(t);
    }
    t->calls.end(own);
    return NULL;
}

/* A fault that is blocked would end the process without a word. */
static void mask_signals(pthread_attr_t *attr)
{
    static const int FAULTS[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP};
    sigset_t mask;
    sigfillset(&mask);
    for (size_t i = 0; i < sizeof FAULTS / sizeof *FAULTS; i++)
        sigdelset(&mask, FAULTS[i]);
    pthread_attr_setsigmask_np(attr, &mask);
}

static bool start(struct turn_thread *t)
{
    pthread_attr_t attr;
    pthread_attr_init(&attr);
    pthread_attr_setstacksize(&attr, STACK_BYTES);
    mask_signals(&attr);
    int failed = pthread_create(&t->id, &attr, live, t);
    pthread_attr_destroy(&attr);
    return !failed;
}

struct turn_thread *turn_thread_new(const char *name, const struct turn_thread_calls *calls)
{
    struct turn_thread *t = xcalloc(1, sizeof *t);
    t->calls = *calls;
    if (!start(t)) {
        free(t);
        return NULL;
    }
    pthread_setname_np(t->id, name);
    return t;
}

void turn_thread_end(struct turn_thread *t)
{
    t->over = true;
    post(&t->turn);
    pthread_join(t->id, NULL);
    free(t);
}

void turn_thread_give(struct turn_thread *t)
{
    t->interruptible = interrupts(SIG_BLOCK);
    hand_over(t, &t->turn);
    take(&t->back);
    if (t->interruptible)
        interrupts(SIG_UNBLOCK);
    errno = t->carried;
}

bool turn_thread_return(struct turn_thread *t)
{
    interrupts(SIG_BLOCK);
    hand_over(t, &t->back);
    await_turn(t);
    return !t->over;
}

void turn_thread_call(struct turn_thread *t, void (*f)(void *arg), void *arg)
{
    t->asked = f, t->asked_arg = arg;
    post(&t->turn);
    take(&t->back);
}
