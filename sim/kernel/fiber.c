/* fiber.c - see fiber.h. */
#include "kernel/fiber.h"
#include <stdint.h>
#include <stdlib.h>
#include "kernel/turn_thread.h"

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/asan_interface.h>
#include <sanitizer/common_interface_defs.h>
#elif defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

/* Boost.Context's C interface (boost/context/detail/fcontext.hpp declares it for C++ only). */
typedef void *fcontext_t;
struct transfer {
    fcontext_t from;
    void *data;
};
extern fcontext_t make_fcontext(void *top, size_t size, void (*entry)(struct transfer));
extern struct transfer jump_fcontext(fcontext_t to, void *data);

_Thread_local struct fiber *fiber_running;

/* Tell AddressSanitizer that the stack is about to change, and that it has changed. */
static inline void leaving(void **fake, const void *bottom, size_t size)
{
#if defined(__SANITIZE_ADDRESS__)
    __sanitizer_start_switch_fiber(fake, bottom, size);
#else
    (void)fake, (void)bottom, (void)size;
#endif
}

static inline void arrived(void *fake, const void **bottom, size_t *size)
{
#if defined(__SANITIZE_ADDRESS__)
    __sanitizer_finish_switch_fiber(fake, bottom, size);
#else
    (void)fake, (void)bottom, (void)size;
#endif
}

/* The same for ThreadSanitizer: `thread` is about to run; *here is who did. */
static inline void switch_thread(void **here, void *thread)
{
#if defined(__SANITIZE_THREAD__)
    if (here)
        *here = __tsan_get_current_fiber();
    __tsan_switch_to_fiber(thread, 0);
#else
    (void)here, (void)thread;
#endif
}

static void *new_thread(void)
{
#if defined(__SANITIZE_THREAD__)
    return __tsan_create_fiber(0);
#else
    return NULL;
#endif
}

static void free_thread(void *thread)
{
#if defined(__SANITIZE_THREAD__)
    __tsan_destroy_fiber(thread);
#else
    (void)thread;
#endif
}

/* A switch keeps the x87 unit's control word and all of SSE's, but not the x87 unit's flags of exceptions.
 * These are put aside before the switch, which would trap if one is not masked. */
enum { X87_FLAGS = 0x3f };

static inline unsigned take_x87_flags(void)
{
    uint16_t status;
    __asm__ volatile("fnstsw %0" : "=a"(status));
    if (__builtin_expect(status & X87_FLAGS, 0))
        __asm__ volatile("fnclex");
    return status & X87_FLAGS;
}

static __attribute__((noinline, cold)) void give_x87_flags(unsigned flags)
{
    struct {
        uint32_t control, status, others[5];
    } unit;
    __asm__ volatile("fnstenv %0" : "=m"(unit));
    unit.status |= flags;
    __asm__ volatile("fldenv %0" ::"m"(unit));
}

/* Another fiber may have been there before, and have been forgotten in the middle of its functions. */
static void clean(void *stack, size_t size)
{
#if defined(__SANITIZE_ADDRESS__)
    __asan_unpoison_memory_region(stack, size);
#else
    (void)stack, (void)size;
#endif
}

static void start(struct transfer t)
{
    struct fiber *f = t.data;
    const uint32_t usual = 0x1f80; /* SSE's: not those of whoever has made the fiber */
    __asm__ volatile("ldmxcsr %0" ::"m"(usual));
    __asm__ volatile(".cfi_undefined rip"); /* nobody called: here a debugger's list of calls ends */
    arrived(NULL, &f->back_stack, &f->back_size);
    f->back = t.from;
    f->entry(f->arg);
    abort(); /* entry must end with fiber_finish */
}

void fiber_begin(struct fiber *f, void *stack, size_t size, void (*entry)(void *), void *arg)
{
    *f = (struct fiber){.stack = stack, .size = size, .entry = entry, .arg = arg};
    clean(stack, size);
    f->thread = new_thread();
    f->self = make_fcontext((char *)stack + size, size, start);
}

void fiber_end(struct fiber *f)
{
    if (f->on)
        turn_thread_end(f->on);
    f->on = NULL;
    if (f->self)
        free_thread(f->thread);
    f->self = NULL;
}

/* Runs f on the calling thread until it switches back. */
static inline void enter(struct fiber *f)
{
    struct fiber *outer = fiber_running;
    void *fake = NULL;
    fiber_running = f;
    leaving(&fake, f->stack, f->size);
    switch_thread(&f->back_thread, f->thread);
    struct transfer t = jump_fcontext(f->self, f);
    arrived(fake, NULL, NULL);
    fiber_running = outer;
    f->self = t.from;
}

void fiber_resume(struct fiber *f)
{
    if (__builtin_expect(f->on != NULL, 0))
        turn_thread_give(f->on);
    else
        enter(f);
}

/* On the fiber's own thread it waits where it is, so that a debugger sees its stack. */
static __attribute__((noinline, cold)) void yield_on_thread(struct fiber *f)
{
    if (!turn_thread_return(f->on))
        fiber_finish(f);
}

void fiber_yield(struct fiber *f)
{
    f->frame = __builtin_frame_address(0);
    if (__builtin_expect(f->on != NULL, 0)) {
        yield_on_thread(f);
        return;
    }
    unsigned flags = take_x87_flags();
    leaving(&f->fake, f->back_stack, f->back_size);
    switch_thread(NULL, f->back_thread);
    struct transfer t = jump_fcontext(f->back, f);
    arrived(f->fake, &f->back_stack, &f->back_size);
    f->back = t.from;
    if (__builtin_expect(flags != 0, 0))
        give_x87_flags(flags);
}

_Noreturn void fiber_finish(struct fiber *f)
{
    take_x87_flags();
    leaving(NULL, f->back_stack, f->back_size);
    switch_thread(NULL, f->back_thread);
    jump_fcontext(f->back, f);
    abort();
}

void fiber_abandon(void *up_to)
{
    clean(__builtin_frame_address(0), (size_t)((char *)up_to - (char *)__builtin_frame_address(0)));
}

/* --- with a thread of its own --- */

static void enter_on_thread(void *arg)
{
    enter(arg);
}

bool fiber_take_thread(struct fiber *f, const char *name, void *(*begin)(void), void (*end)(void *own))
{
    f->on = turn_thread_new(name, &(struct turn_thread_calls){begin, enter_on_thread, end, f});
    return f->on;
}

void fiber_call_there(struct fiber *f, void (*call)(void *arg), void *arg)
{
    if (f->on)
        turn_thread_call(f->on, call, arg);
    else
        call(arg);
}

void *fiber_arg(const struct fiber *f)
{
    return f->arg;
}
