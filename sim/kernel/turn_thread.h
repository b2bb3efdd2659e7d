/* turn_thread.h - a thread that runs only while it has the turn. Exactly one of the thread and whoever gives
 * it the turn runs, so that both may use the same data, as if they were one thread.
 *
 *     giver:   turn_thread_give ---.                  .--> goes on
 *     thread:                      '--> runs --> turn_thread_return (waits)
 *
 * The turn carries errno along, which each thread has for itself; and who takes SIGINT, so that a user who
 * interrupts the program in a debugger sees the thread that runs. */
#ifndef KERNEL_TURN_THREAD_H
#define KERNEL_TURN_THREAD_H
#include <stdbool.h>

struct turn_thread;

/* What runs on the thread: begin() first, run(arg) at the first turn, end(what begin returned) last. run()
 * returns when it has finished, or when turn_thread_return() has told it to. */
struct turn_thread_calls {
    void *(*begin)(void);
    void (*run)(void *arg);
    void (*end)(void *own);
    void *arg;
};

/* name: for debuggers, at most 15 letters. The thread takes no other signals than its own faults and SIGINT.
 * NULL: there is no thread to be had. */
struct turn_thread *turn_thread_new(const char *name, const struct turn_thread_calls *calls);
/* Without the turn: makes the thread leave run(), waits for its end, and frees it. */
void turn_thread_end(struct turn_thread *t);

/* Gives the thread the turn; returns when it is back, or run() has finished. Not after that. */
void turn_thread_give(struct turn_thread *t);
/* From inside run(): gives the turn back, and waits for the next. False: run() is to return at once. */
bool turn_thread_return(struct turn_thread *t);
/* Without the turn: calls f(arg) on the thread, wherever it waits. */
void turn_thread_call(struct turn_thread *t, void (*f)(void *arg), void *arg);
#endif
