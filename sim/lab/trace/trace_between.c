/* trace_between.c - what a program did between two of its calls: see trace_model.h. */
#include <stdlib.h>
#include <string.h>
#include "guest/elffile.h"
#include "lab/trace/trace_parts.h"

/* x86-64: call rel32; jcc rel32 and jmp rel32 */
enum { CALL = 0xe8, CALL_BYTES = 5, TWO_BYTES = 0x0f, JCC = 0x80, JCC_BYTES = 6, JMP = 0xe9, JMP_BYTES = 5 };

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
        if (!strcmp(x->called[i], function))
            return;
    if (x->count < TRACE_MOST_CALLED)
        x->called[x->count++] = function;
    else
        x->more = true;
}

/* Where the instruction at c, of so many bytes that end with a distance, leads to. */
static uint64_t target_of(const unsigned char *c, uint64_t at, int bytes)
{
    int32_t distance;
    memcpy(&distance, c + bytes - (int)sizeof distance, sizeof distance);
    return at + (uint64_t)bytes + (uint64_t)(int64_t)distance;
}

/* Adds the functions of the program that the code from `begin` to `end` calls: each `call` whose target is
 * the beginning of one. */
static void add_calls(const struct trace *t, int32_t stack, uint64_t begin, uint64_t end,
                      struct trace_between *x)
{
    const struct elf_file *f = trace_stack_file(t, stack);
    const unsigned char *code = end > begin ? elf_at(f, begin, end - begin) : NULL;
    for (uint64_t i = 0; code && i + CALL_BYTES <= end - begin; i++) {
        const char *name;
        if (code[i] != CALL)
            continue;
        uint64_t target = target_of(code + i, begin + i, CALL_BYTES);
        const Elf64_Sym *s = elf_function_at(f, target, &name);
        if (!s || s->st_value != target)
            continue;
        struct trace_frame frame = trace_frame_at(t, stack, (int64_t)target + 1);
        if (!frame.library && !frame.layer && frame.file && *frame.function)
            add(x, frame.function);
        i += CALL_BYTES - 1;
    }
}

/* The beginning and the end of a function's code. */
struct span {
    uint64_t begin, end;
};

static bool find_function(const struct trace *t, int32_t stack, int64_t address, struct span *function)
{
    const char *name;
    const Elf64_Sym *s = elf_function_at(trace_stack_file(t, stack), (uint64_t)address - 1, &name);
    if (s)
        *function = (struct span){s->st_value, s->st_value + s->st_size};
    return s;
}

/* The loop that leads from `from` back to before `to`: the first jump behind `from` that does so. Sets
 * *jump and *head; false: none is found. */
static bool find_loop(const struct elf_file *f, struct span function, uint64_t from, uint64_t to,
                      uint64_t *jump, uint64_t *head)
{
    const unsigned char *code = from < function.end ? elf_at(f, from, function.end - from) : NULL;
    for (uint64_t i = 0; code && from + i + JCC_BYTES <= function.end; i++) {
        bool jcc = code[i] == TWO_BYTES && (code[i + 1] & 0xf0) == JCC;
        if (!jcc && code[i] != JMP)
            continue;
        *jump = from + i;
        *head = target_of(code + i, *jump, jcc ? JCC_BYTES : JMP_BYTES);
        if (*head >= function.begin && *head < to)
            return true;
    }
    return false;
}

/* Adds what the code between two places of a function calls, be the second one behind the first, or before it
 * in a loop. */
static void add_between(const struct trace *t, int32_t stack, struct span function, uint64_t from,
                        uint64_t to, struct trace_between *x)
{
    uint64_t jump, head;
    if (from <= to) {
        add_calls(t, stack, from, to, x);
    } else if (find_loop(trace_stack_file(t, stack), function, from, to, &jump, &head)) {
        add_calls(t, stack, from, jump, x);
        add_calls(t, stack, head, to, x);
    }
}

struct trace_between trace_between(const struct trace *t, int32_t before, int32_t after)
{
    struct trace_between x = {0};
    int before_count, after_count, a, b;
    const struct trace_frame *from = trace_stack(t, before, &before_count);
    const struct trace_frame *to = trace_stack(t, after, &after_count);
    if (!to || !after_count)
        return x;
    if (!from)
        b = after_count - 1; /* the program begins */
    else if (!common(from, before_count, to, after_count, &a, &b))
        return x;
    struct span function;
    x.in = to[b].library ? NULL : &to[b];
    if (x.in && find_function(t, after, to[b].returns_to, &function))
        add_between(t, after, function, from ? (uint64_t)from[a].returns_to : function.begin,
                    (uint64_t)to[b].returns_to - CALL_BYTES, &x);
    return x;
}
