/* trace_between.c - what a program did between two of its calls: see trace_model.h. */
#include <stdlib.h>
#include <string.h>
#include "guest/elf_functions.h"
#include "kernel/xalloc.h"
#include "lab/trace/program_code.h"
#include "lab/trace/trace_parts.h"

/* Ways through a function: from one of its instructions to a call, or to its end. */
struct ways {
    const struct program_code *code;
    const struct elf_file *file;
    uint64_t begin, end; /* the function's code */
    size_t to;           /* the point of the call; WAYS_OUT: the function's end */
    size_t barred;  /* a point that they do not come over: a call that would be in the trace; or WAYS_OUT */
    size_t *points; /* those that ways come to, the first one first, */
    size_t count;   /* so many */
    bool *seen;     /* by point of the code: it is among them */
    bool *on;       /* and a way leads from it to `to` */
};
#define WAYS_OUT SIZE_MAX

/* Do the frames belong to one function? */
static bool same_function(const struct trace_frame *a, const struct trace_frame *b)
{
    return !strcmp(a->function, b->function) &&
           (a->file == b->file || (a->file && b->file && !strcmp(a->file, b->file)));
}

/* Of the frames of two stacks, from the outermost on, the last two that are of one function: *a and *b. */
static bool common(const struct trace_frame *before, int before_count, const struct trace_frame *after,
                   int after_count, int *a, int *b)
{
    *a = before_count - 1, *b = after_count - 1;
    if (*a < 0 || *b < 0 || !same_function(&before[*a], &after[*b]))
        return false;
    while (*a > 0 && *b > 0 && before[*a].returns_to == after[*b].returns_to &&
           same_function(&before[*a - 1], &after[*b - 1]))
        --*a, --*b;
    return true;
}

static void add(struct trace_between *x, const char *function)
{
    for (int i = 0; i < x->count; i++)
        if (!strcmp(x->worked[i], function))
            return;
    if (x->count < TRACE_MOST_WORKED)
        x->worked[x->count++] = function;
    else
        x->more = true;
}

/* Does a function begin at the address, other than the cold part of one? */
static bool begins(const struct elf_file *f, uint64_t address)
{
    const char *name;
    const Elf64_Sym *s = address == CODE_NOWHERE ? NULL : elf_function_at(f, address, &name);
    return s && s->st_value == address && !strstr(name, ".cold");
}

/* A jump to another function, which returns to the caller of this one. */
static bool is_last_call(const struct ways *w, const struct code_point *p)
{
    return (p->kind == CODE_JUMP || p->kind == CODE_BRANCH) && p->target != w->begin &&
           begins(w->file, p->target);
}

static bool is_way_out(const struct ways *w, size_t point)
{
    const struct code_point *p = &w->code->points[point];
    return p->kind == CODE_END || is_last_call(w, p);
}

/* The points that follow one; their number. Behind a jump whose target is not known, as of a switch,
 * these are all of the function: the number is 0, and *any is true. */
static int following(const struct ways *w, size_t point, size_t next[2], bool *any)
{
    const struct code_point *p = &w->code->points[point];
    int count = 0;
    *any = p->kind == CODE_JUMP && p->target == CODE_NOWHERE;
    if (point == w->to || point == w->barred || p->kind == CODE_END)
        return 0;
    if ((p->kind == CODE_BRANCH || p->kind == CODE_CALL) && p->next != w->end && point + 1 < w->code->count)
        next[count++] = point + 1;
    if ((p->kind == CODE_BRANCH || p->kind == CODE_JUMP) && p->target != CODE_NOWHERE &&
        !is_last_call(w, p)) {
        size_t target = program_code_find(w->code, p->target);
        if (target < w->code->count)
            next[count++] = target;
    }
    return count;
}

static void see(struct ways *w, size_t point)
{
    if (!w->seen[point])
        w->points[w->count++] = point;
    w->seen[point] = true;
}

static void find_points(struct ways *w, size_t from)
{
    size_t first = program_code_find(w->code, w->begin), last = program_code_find(w->code, w->end);
    if (from < last)
        see(w, from);
    for (size_t i = 0; i < w->count; i++) {
        size_t next[2];
        bool any;
        for (int n = following(w, w->points[i], next, &any); n-- > 0;)
            see(w, next[n]);
        for (size_t k = first; any && k < last; k++)
            see(w, k);
    }
}

/* Is one of the points that follow in the set? */
static bool leads_into(const struct ways *w, size_t point, const bool *set)
{
    size_t next[2];
    bool any;
    for (int n = following(w, point, next, &any); n-- > 0;)
        if (set[next[n]])
            return true;
    for (size_t i = 0; any && i < w->count; i++)
        if (set[w->points[i]])
            return true;
    return false;
}

/* Keeps the points from which a way leads to `to`; false: none does. */
static bool find_ways(struct ways *w)
{
    bool found = false, more = true;
    for (size_t i = 0; i < w->count; i++) {
        size_t point = w->points[i];
        found |= w->on[point] = w->to == WAYS_OUT ? is_way_out(w, point) : point == w->to;
    }
    while (found && more) {
        more = false;
        for (size_t i = w->count; i-- > 0;)
            if (!w->on[w->points[i]] && leads_into(w, w->points[i], w->on))
                more = w->on[w->points[i]] = true;
    }
    return found;
}

/* Is there a loop on the ways? Takes away, again and again, the points from which none goes on. */
static bool have_loop(const struct ways *w)
{
    bool *left = xcalloc(w->code->count, sizeof *left), more = true;
    size_t count = 0;
    for (size_t i = 0; i < w->count; i++)
        count += left[w->points[i]] = w->on[w->points[i]];
    while (more) {
        more = false;
        for (size_t i = w->count; i-- > 0;)
            if (left[w->points[i]] && !leads_into(w, w->points[i], left)) {
                left[w->points[i]] = false;
                count--;
                more = true;
            }
    }
    free(left);
    return count > 0;
}

/* The point of the call that returns to the address; false: there is none. */
static bool find_call(const struct program_code *code, int64_t returns_to, size_t *point)
{
    size_t behind = program_code_find(code, (uint64_t)returns_to);
    if (!behind || code->points[behind - 1].next != (uint64_t)returns_to)
        return false;
    *point = behind - 1;
    return true;
}

/* From the return to an address (0: from the function's beginning) to the call that returns to another
 * one (0: to the function's end). */
struct stretch {
    int64_t from, to;
    bool after_nx; /* it begins behind a call of NX itself, and so does not come there again */
};

/* Finds the ways of a stretch in the function that has the address; false: there are none. The caller ends
 * them by end_ways() in either case. */
static bool begin_ways(const struct trace *t, int32_t stack, uint64_t address, struct stretch stretch,
                       struct ways *w)
{
    const char *name;
    *w = (struct ways){.code = trace_stack_code(t, stack), .file = trace_stack_file(t, stack)};
    const Elf64_Sym *s = elf_function_at(w->file, address, &name);
    w->to = w->barred = WAYS_OUT;
    if (!s || (stretch.to && !find_call(w->code, stretch.to, &w->to)))
        return false;
    if (stretch.after_nx)
        find_call(w->code, stretch.from, &w->barred);
    w->begin = s->st_value;
    w->end = s->st_value + s->st_size;
    w->points = xcalloc(w->code->count + 1, sizeof *w->points);
    w->seen = xcalloc(w->code->count + 1, sizeof *w->seen);
    w->on = xcalloc(w->code->count + 1, sizeof *w->on);
    find_points(w, program_code_find(w->code, stretch.from ? (uint64_t)stretch.from : w->begin));
    return find_ways(w);
}

static void end_ways(struct ways *w)
{
    free(w->points);
    free(w->seen);
    free(w->on);
}

/* Does the function at the address hardly work: has it no loop, and calls nothing but the simulator? */
static bool is_small(const struct trace *t, int32_t stack, uint64_t address)
{
    struct ways w;
    bool found = begin_ways(t, stack, address, (struct stretch){0}, &w), calls = false;
    for (size_t i = 0; found && i < w.count; i++) {
        const struct code_point *p = &w.code->points[w.points[i]];
        const char *name;
        const Elf64_Sym *s = p->target == CODE_NOWHERE ? NULL : elf_function_at(w.file, p->target, &name);
        calls |= is_last_call(&w, p) || (p->kind == CODE_CALL && !(s && !strncmp(name, "nxc_", 4)));
    }
    bool small = found && !calls && !have_loop(&w);
    end_ways(&w);
    return small;
}

/* Adds the functions of the program that are called on the ways. */
static void add_calls(const struct trace *t, int32_t stack, const struct ways *w, struct trace_between *x)
{
    for (size_t i = 0; i < w->count; i++) {
        const struct code_point *p = &w->code->points[w->points[i]];
        if (!w->on[w->points[i]] || w->points[i] == w->to || !(p->kind == CODE_CALL || is_last_call(w, p)) ||
            !begins(w->file, p->target) || is_small(t, stack, p->target))
            continue;
        struct trace_frame frame = trace_frame_at(t, stack, (int64_t)p->target + 1);
        if (!frame.library && !frame.layer && frame.file && *frame.function)
            add(x, frame.function);
    }
}

/* Adds what may have worked on the ways of a stretch in the function of the frame f, be it called
 * there. False: it has no way. */
static bool add_ways(const struct trace *t, int32_t stack, const struct trace_frame *f,
                     struct stretch stretch, struct trace_between *x)
{
    struct ways w;
    bool found = begin_ways(t, stack, (uint64_t)f->returns_to - 1, stretch, &w);
    if (found && !f->layer && have_loop(&w))
        add(x, f->function);
    if (found)
        add_calls(t, stack, &w, x);
    end_ways(&w);
    return found;
}

/* Has the frame code of its own: is it neither the library's nor inlined into the next one? */
static bool is_own(const struct trace_frame *frames, int count, int i)
{
    return !frames[i].library && (i + 1 == count || frames[i].returns_to != frames[i + 1].returns_to);
}

/* Is it the frame that has called NX, or the one that this frame was inlined into? */
static bool has_called_nx(const struct trace_frame *frames, int i)
{
    while (i > 0 && frames[i - 1].returns_to == frames[i].returns_to)
        i--;
    return i == 0 || frames[i - 1].library;
}

/* The functions that returned since `before`, and those that were called until `after`: below the
 * frames a and b. */
static void add_inner(const struct trace *t, int32_t before, int32_t after, int a, int b,
                      struct trace_between *x)
{
    int count;
    const struct trace_frame *from = trace_stack(t, before, &count);
    for (int i = 0; from && i < a; i++)
        if (is_own(from, count, i))
            add_ways(t, before, &from[i], (struct stretch){from[i].returns_to, 0, has_called_nx(from, i)}, x);
    const struct trace_frame *to = trace_stack(t, after, &count);
    for (int i = b - 1; i >= 0; i--)
        if (is_own(to, count, i))
            add_ways(t, after, &to[i], (struct stretch){.to = to[i].returns_to}, x);
}

struct trace_between trace_between(const struct trace *t, int32_t before, int32_t after)
{
    struct trace_between x = {0};
    int before_count, after_count, a = 0, b;
    const struct trace_frame *from = trace_stack(t, before, &before_count);
    const struct trace_frame *to = trace_stack(t, after, &after_count);
    if (!to) { /* the program or the handler ends */
        add_inner(t, before, after, before_count, 0, &x);
        return x;
    }
    if (!after_count)
        return x;
    if (!from)
        b = after_count - 1; /* the program begins */
    else if (!common(from, before_count, to, after_count, &a, &b))
        return x;
    x.in = to[b].library ? NULL : &to[b];
    /* Where no way in the shared function leads to the second call, it has returned and was called again. */
    for (; b < after_count && (!from || a < before_count); a++, b++) {
        struct stretch stretch = {.to = to[b].returns_to};
        if (from)
            stretch.from = from[a].returns_to, stretch.after_nx = has_called_nx(from, a);
        if (to[b].library || !add_ways(t, after, &to[b], stretch, &x))
            continue;
        x.in = &to[b];
        add_inner(t, before, after, a, b, &x);
        break;
    }
    return x;
}
