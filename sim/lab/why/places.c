/* places.c - see places.h. */
#include "lab/why/places.h"
#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

/* The texts of a stack, so that its frames are asked once. */
struct known {
    const char *line, *function;
};

struct places {
    const struct trace *t;
    void *texts; /* of tsearch */
    struct known *of;
    int32_t count; /* of `of`, by stack */
};

struct places *places_new(const struct trace *t)
{
    struct places *p = xcalloc(1, sizeof *p);
    p->t = t;
    return p;
}

void places_free(struct places *p)
{
    if (!p)
        return;
    tdestroy(p->texts, free);
    free(p->of);
    free(p);
}

static int compare(const void *a, const void *b)
{
    return strcmp(a, b);
}

/* The one text that equals `text`, which the function takes over. */
static const char *only(struct places *p, char *text)
{
    char **found = xchecked(tsearch(text, &p->texts, compare));
    if (*found != text)
        free(text);
    return *found;
}

const char *places_text(struct places *p, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    char *text = xvasprintf(format, list);
    va_end(list);
    return only(p, text);
}

static const char *line_of(struct places *p, const struct trace_frame *f)
{
    if (!f)
        return places_text(p, "%s", "");
    if (!f->file)
        return places_text(p, "%s", f->function);
    const char *slash = strrchr(f->file, '/'), *file = slash ? slash + 1 : f->file;
    return *f->function ? places_text(p, "%s:%d (%s)", file, f->line, f->function)
                        : places_text(p, "%s:%d", file, f->line);
}

/* The innermost frame of the program's own: neither a function of NX's library, nor nxc_enter, through which a
 * program that computes comes to the simulator. NULL: none is known. */
static const struct trace_frame *own_frame(const struct trace *t, int32_t stack)
{
    int count;
    const struct trace_frame *f = trace_stack(t, stack, &count);
    for (; count > 0; f++, count--)
        if (!f->library && *f->function && strncmp(f->function, "nxc_", 4) != 0)
            return f;
    return NULL;
}

static const struct known *known(struct places *p, int32_t stack)
{
    static const struct known NOTHING = {"", ""};
    if (stack == TRACE_NONE)
        return &NOTHING;
    if (stack >= p->count) {
        int32_t more = 2 * stack + 16;
        p->of = xreallocarray(p->of, (size_t)more, sizeof *p->of);
        memset(p->of + p->count, 0, (size_t)(more - p->count) * sizeof *p->of);
        p->count = more;
    }
    struct known *k = &p->of[stack];
    if (!k->line) {
        const struct trace_frame *f = own_frame(p->t, stack);
        k->line = line_of(p, f);
        k->function = places_text(p, "%s", f ? f->function : "");
    }
    return k;
}

const char *places_line(struct places *p, int32_t stack)
{
    return known(p, stack)->line;
}

const char *places_function(struct places *p, int32_t stack)
{
    return known(p, stack)->function;
}

const char *places_call(struct places *p, int32_t call)
{
    const struct trace_call *c = &p->t->calls[call];
    const char *line = places_line(p, c->stack);
    return places_text(p, *line ? "%s at %s" : "%s%s", trace_called_name(p->t, c), line);
}
