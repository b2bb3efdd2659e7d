/* where.c - see where.h. */
#include "nx_api/mpi/where.h"
#include <errno.h>
#include <execinfo.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <ucontext.h>
#include <unistd.h>
#include "nx_api/mpi/addr2line.h"
#include "nx_api/mpi/library_call.h"
#include "nx_api/mpi/stack.h"

enum { MOST_FRAMES = 200, MOST_TOLD = 16 };

struct frame {
    uintptr_t address; /* inside the call's instruction, or that of the instruction that crashed */
    bool interrupted;  /* libnx.a lies between this and the frame before: a handler has interrupted it */
    const char *function, *place; /* NULL: not known */
};

struct frames {
    const char *library_call; /* the program is in a library that this function of it is of; "": not known */
    bool in_nothing;          /* it has called an address that is no function's */
    struct frame all[MOST_TOLD];
    size_t count;
};

/* --- the stack --- */

static uintptr_t crashed_at(const void *context)
{
    return (uintptr_t)((const ucontext_t *)context)->uc_mcontext.gregs[REG_RIP];
}

/* Addresses from the innermost; the first is that of the instruction that the signal has interrupted. After
 * a call of no function, which no unwinder understands, there is only what called it. */
static int read_stack(void **addresses, const void *context, int *first, bool *in_nothing)
{
    int depth = backtrace(addresses, MOST_FRAMES);
    *first = 0;
    while (context && *first < depth && (uintptr_t)addresses[*first] != crashed_at(context))
        ++*first;
    if (*first < depth)
        return depth;
    *in_nothing = true;
    addresses[0] = (void *)crashed_at(context);
    addresses[1] = *(void **)((const ucontext_t *)context)->uc_mcontext.gregs[REG_RSP];
    *first = 0;
    return 2;
}

static void add(struct frames *f, uintptr_t address, bool exact, bool interrupted)
{
    f->all[f->count++] = (struct frame){.address = address - !exact, .interrupted = interrupted};
}

static void find_frames(struct frames *f, const void *context)
{
    void *addresses[MOST_FRAMES];
    int first, depth = read_stack(addresses, context, &first, &f->in_nothing);
    bool own = false, other = false, polled = false;
    for (int i = first; i < depth && f->count < MOST_TOLD; i++) {
        uintptr_t address = (uintptr_t)addresses[i];
        bool exact = context && i == first;
        if (stack_in_library(address)) {
            own = true;
            polled = stack_in_poll(address);
        } else if (!stack_in_file(address - !exact)) {
            other = true;
        } else {
            if (other && !own && !f->count)
                f->library_call = library_call_name(address) ? library_call_name(address) : "";
            add(f, polled ? stack_poll_place(address) : address, exact, own && f->count);
            if (polled)
                return; /* what is behind a poll cannot be found: stack.c */
            own = other = false;
        }
    }
}

/* --- lines --- */

/* All that addr2line says. */
static size_t read_all(int from, char *text, size_t most)
{
    size_t count = 0;
    for (ssize_t n = 1; count < most && n != 0;) {
        n = syscall(SYS_read, from, text + count, most - count);
        if (n < 0 && errno != EINTR)
            break;
        count += n > 0 ? (size_t)n : 0;
    }
    return count;
}

static void cut_up(struct frames *f, char *text)
{
    char *rest = text;
    for (size_t i = 0; i < f->count; i++) {
        char *function = strsep(&rest, "\n"), *place = strsep(&rest, "\n");
        if (!rest)
            return;
        f->all[i].place = addr2line_place(place);
        f->all[i].function = addr2line_function(function, f->all[i].place);
    }
}

/* The texts are in the given space. */
static void find_lines(struct frames *f, char *space, size_t size)
{
    static char digits[MOST_TOLD][ADDR2LINE_DIGITS];
    const char *argv[ADDR2LINE_BEFORE + MOST_TOLD + 1];
    pid_t child;
    for (size_t i = 0; i < f->count; i++) {
        addr2line_digits(digits[i], stack_in_file(f->all[i].address));
        argv[ADDR2LINE_BEFORE + i] = digits[i];
    }
    argv[ADDR2LINE_BEFORE + f->count] = NULL;
    int from = addr2line_start(argv, &child);
    if (from < 0)
        return;
    space[read_all(from, space, size - 1)] = '\0';
    syscall(SYS_close, from);
    while (waitpid(child, NULL, 0) < 0 && errno == EINTR)
        ;
    cut_up(f, space);
}

/* --- the text --- */

static void append_frame(struct safe_text *t, const char *how, const struct frame *frame)
{
    safe_append(t, how);
    safe_append(t, frame->function);
    safe_append(t, "()");
    if (frame->place) {
        safe_append(t, " (");
        safe_append(t, frame->place);
        safe_append(t, ")");
    }
    safe_append(t, "\n");
}

static void append_library(struct safe_text *t, const struct frames *f)
{
    if (f->in_nothing) {
        safe_append(t, "  in no function: it called a pointer that leads to none\n");
    } else if (f->library_call) {
        safe_append(t, "  in ");
        safe_append(t, f->library_call);
        safe_append(t, *f->library_call ? "() of a library\n" : "a library\n");
    }
}

void where_append(struct safe_text *t, const void *context)
{
    static char space[20000];
    struct frames f = {.count = 0};
    int before = errno;
    find_frames(&f, context);
    if (f.count)
        find_lines(&f, space, sizeof space);
    append_library(t, &f);
    for (size_t i = 0; i < f.count; i++) {
        bool innermost = i == 0 && context && !f.library_call && f.all[0].address == crashed_at(context);
        if (!f.all[i].function || strcmp(f.all[i].function, "_start") == 0)
            break;
        append_frame(t,
                     innermost              ? "  in "
                     : f.all[i].interrupted ? "  which interrupted "
                                            : "  called from ",
                     &f.all[i]);
    }
    errno = before;
}

void where_begin(void)
{
    void *one[1];
    backtrace(one, 1);
}
