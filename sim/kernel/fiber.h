/* fiber.h - a thread of control with a stack of the caller's, switched to and from by hand.
 * On Boost.Context's fcontext; sanitizer builds tell the sanitizers of every switch. */
#ifndef FIBER_FIBER_H
#define FIBER_FIBER_H
#include <stdbool.h>
#include <stddef.h>

struct turn_thread;

/* Nobody else's business: here so that a fiber can lie where its owner wants it. */
struct fiber {
    /* crossing.h: where its stack begins for calls of a program that it runs (NULL: it runs none), and the
     * end of the program's stack */
    void *level, *program_top;
    void *stack;
    /* what a switch wants */
    void *self, *back;      /* where it goes on, and who resumed it */
    struct turn_thread *on; /* its own thread; NULL: it runs on whichever thread resumes it */
    const void *frame;      /* of fiber_yield */
    size_t size;
    void (*entry)(void *);
    void *arg;
    const void *back_stack; /* of the resumer, for the sanitizers */
    size_t back_size;
    void *fake;                 /* the sanitizers' shadow of the side not running */
    void *thread, *back_thread; /* ThreadSanitizer takes each fiber to be a thread */
};

/* Makes f a fiber that will run entry(arg) on [stack, stack + size). entry must end with fiber_finish(). */
void fiber_begin(struct fiber *f, void *stack, size_t size, void (*entry)(void *), void *arg);
/* There is none any more, if there was; what it was doing is forgotten. Not from inside it. */
void fiber_end(struct fiber *f);

/* Gives f, which has not been resumed yet, a thread of its own with a name (at most 15 letters): for
 * debuggers, which know threads and no fibers. Each resumption then takes some microseconds. begin() and
 * end() are called on the thread. False: there is no thread to be had; f is a fiber as any other. */
bool fiber_take_thread(struct fiber *f, const char *name, void *(*begin)(void), void (*end)(void *own));
/* While f does not run: calls call(arg) on f's thread, on its stack below where it waits; on the calling
 * thread if f has none. */
void fiber_call_there(struct fiber *f, void (*call)(void *arg), void *arg);

/* From the scheduler: run f until it calls fiber_yield or fiber_finish. */
void fiber_resume(struct fiber *f);
/* From inside f: back to whoever resumed it. f is not to be resumed any more when it has finished, which it
 * may do in a handler of a signal. */
void fiber_yield(struct fiber *f);
_Noreturn void fiber_finish(struct fiber *f);
/* The one that runs on the calling thread, NULL: none; and the arg it was made with. */
extern _Thread_local struct fiber *fiber_running;
static inline struct fiber *fiber_current(void)
{
    return fiber_running;
}
void *fiber_arg(const struct fiber *f);
/* From inside: the stack below an address is not going to be returned to. */
void fiber_abandon(void *up_to);
/* The frame pointer where it waits in fiber_yield(); NULL: it has not waited yet. Stale while it runs. */
static inline const void *fiber_frame(const struct fiber *f)
{
    return f->frame;
}
/* Where the innermost of its stack begins while it does not run. NULL: f is all zero, or has ended. */
static inline const void *fiber_innermost(const struct fiber *f)
{
    return f->self;
}
#endif
