/* trace.c - see trace.h. */
#include "node/trace.h"
#include <stdlib.h>
#include "node/image.h"

enum { MOST_CALLS = 24 };

bool trace_in_stack(const struct node *n, uintptr_t address)
{
    uintptr_t stack = (uintptr_t)n->stack;
    return address >= stack && address + 2 * sizeof(uintptr_t) <= stack + n->stack_bytes;
}

int trace_walk(const struct node *n, uintptr_t frame, uintptr_t *returns, int most)
{
    int depth = 0;
    while (depth < most && frame % sizeof frame == 0 && trace_in_stack(n, frame)) {
        uintptr_t next = ((uintptr_t *)frame)[0];
        returns[depth++] = ((uintptr_t *)frame)[1];
        if (next <= frame)
            break;
        frame = next;
    }
    return depth;
}

bool trace_in_program(const struct node *n, uintptr_t address)
{
    return address - (uintptr_t)n->program < n->image_bytes;
}

void trace_print(FILE *f, const struct node *n, const char *how, uintptr_t address)
{
    char where[256];
    if (trace_in_program(n, address))
        fprintf(f, "\n  %s %s", how,
                node_image_where(n->file, address - (uintptr_t)n->program, where, sizeof where));
}

void trace_print_calls(FILE *f, const struct node *n, uintptr_t frame)
{
    uintptr_t returns[MOST_CALLS];
    int depth = trace_walk(n, frame, returns, MOST_CALLS);
    for (int i = 0; i < depth; i++)
        trace_print(f, n, "called from", returns[i] - 1);
}

/* --- lines --- */

enum { MOST_LINES = 64 };

struct trace_lines {
    struct found {
        const struct node_image *file;
        uintptr_t offset;
        char text[100]; /* "": not known, or the library's */
    } found[MOST_LINES];
    int count;
};

struct trace_lines *trace_lines_new(void)
{
    struct trace_lines *t = calloc(1, sizeof *t);
    if (!t)
        abort();
    return t;
}

void trace_lines_free(struct trace_lines *t)
{
    free(t);
}

static const char *line_of(struct trace_lines *t, const struct node_image *file, uintptr_t offset)
{
    for (int i = 0; i < t->count; i++)
        if (t->found[i].file == file && t->found[i].offset == offset)
            return t->found[i].text;
    if (t->count == MOST_LINES)
        return "";
    struct found *f = &t->found[t->count++];
    *f = (struct found){.file = file, .offset = offset};
    if (!node_image_line(file, offset, f->text, sizeof f->text))
        f->text[0] = '\0';
    return f->text;
}

const char *trace_line(struct trace_lines *t, const struct node *n)
{
    uintptr_t returns[MOST_CALLS];
    int depth = trace_walk(n, n->frame, returns, MOST_CALLS);
    for (int i = 0; i < depth; i++) {
        if (!trace_in_program(n, returns[i] - 1))
            continue;
        const char *text = line_of(t, n->file, returns[i] - 1 - (uintptr_t)n->program);
        if (*text)
            return text;
    }
    return NULL;
}
