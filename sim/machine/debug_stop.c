/* debug_stop.c - see debug_stop.h. */
#include "machine/debug_stop.h"
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include "files/virtual_time.h"
#include "guest/debugger.h"
#include "guest/elf_functions.h"
#include "guest/image.h"
#include "kernel/opaque.h"
#include "guest/backtrace.h"
#include "machine/whereabouts.h"
#include "nx_api/contract/program_image.h"

enum { MOST_CALLS = 24, MOST_NAME = 200 };

/* Where a program is, for the debugger. */
struct place {
    uintptr_t resume;
    bool in_call;
    char function[MOST_NAME];
};

/* (The compiler is not to know that it does nothing, nor to change its arguments.) */
OPAQUE void touchstone_stops(const void *resume, const char *function, bool in_call)
{
    __asm__ volatile("" ::"r"(resume), "r"(function), "r"(in_call) : "memory");
}

static void stop_on_thread(void *arg)
{
    const struct place *p = arg;
    touchstone_stops((const void *)p->resume, p->function, p->in_call);
}

/* Is a return address in a function of the user's, not of a library in the program? */
static bool is_users(const struct node *n, uintptr_t returns)
{
    char line[MOST_NAME];
    return backtrace_in_program(n, returns) &&
           node_image_line(n->guest.file, returns - 1 - (uintptr_t)n->guest.program, line, sizeof line);
}

/* Where a program goes on that has switched away: the innermost of the user's functions; without lines, the
 * innermost of the program. */
static uintptr_t resumes_at(const struct node *n)
{
    uintptr_t returns[MOST_CALLS], in_program = 0;
    int depth = backtrace_walk(n, (uintptr_t)fiber_frame(&n->lp.fiber), returns, MOST_CALLS);
    for (int i = 0; i < depth; i++) {
        if (is_users(n, returns[i]))
            return returns[i];
        if (!in_program && backtrace_in_program(n, returns[i]))
            in_program = returns[i];
    }
    return in_program;
}

static struct place place_of(const struct node *n)
{
    const char *function = "";
    struct place p = {.resume = resumes_at(n), .in_call = n->call.name};
    if (p.resume)
        elf_function_at(node_image_elf(n->guest.file), p.resume - 1 - (uintptr_t)n->guest.program, &function);
    snprintf(p.function, sizeof p.function, "%s", function);
    return p;
}

static struct node *wanted_node(const struct node_system *s)
{
    const struct debug_stop_options *o = &s->stop->options;
    return o->host ? s->host : o->node < s->count ? s->nodes[o->node] : NULL;
}

static bool runs(const struct node *n)
{
    return n && n->lp.state != LP_ENDED;
}

static void stop_here(struct node_system *s, struct node *n, struct place p)
{
    s->stop->pending = false;
    if (s->isolate)
        p.function[0] = '\0'; /* it is not on the stack of the thread that stops */
    if (runs(n))
        fiber_call_there(&n->lp.fiber, stop_on_thread, &p);
    else
        stop_on_thread(&p);
}

static void stop_at_main(struct node_system *s, struct node *n)
{
    stop_here(s, n, (struct place){.resume = (uintptr_t)n->guest.image->main});
}

static void stop_at_time(struct node_system *s)
{
    struct node *n = wanted_node(s);
    if (n) {
        char *where = whereabouts_of(n);
        fprintf(s->out[1], "touchstone run: all nodes have come to %s; %s\n",
                virtual_time_moment(s->stop->options.time).text, where);
        free(where);
    }
    stop_here(s, n, runs(n) ? place_of(n) : (struct place){0});
}

void debug_stop_begin(struct node_system *s, struct debug_stop *stop,
                      const struct debug_stop_options *options)
{
    struct schedule *schedule = &s->schedule;
    *stop = (struct debug_stop){*options, options->wanted, schedule->max_time};
    s->stop = stop, s->pauses = debug_stop_at_limit;
    if (stop->pending && options->time && options->time <= schedule->max_time)
        schedule->max_time = options->time - 1;
    debug_stop_loaded(s);
}

void debug_stop_loaded(struct node_system *s)
{
    if (!s->debugger)
        return;
    debugger_tell(s->debugger);
    if (!s->stop || !s->stop->pending || s->stop->options.time)
        return;
    struct node *n = wanted_node(s);
    if (runs(n))
        stop_at_main(s, n);
}

bool debug_stop_at_limit(struct node_system *s)
{
    struct debug_stop *stop = s->stop;
    if (!stop->pending || s->schedule.max_time != stop->options.time - 1)
        return false;
    s->schedule.max_time = stop->limit;
    stop_at_time(s);
    return true;
}

void debug_stop_end(struct node_system *s, bool deadlock)
{
    if (s->stop && s->stop->pending)
        fprintf(s->out[1], "touchstone run: the run has ended before the place where --gdb was to stop\n");
    if (s->debugger && deadlock && debugger_is_attached())
        raise(SIGTRAP);
}
