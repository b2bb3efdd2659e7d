/* program_places.c - see program_places.h. */
#include "lab/trace/program_places.h"
#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

/* The texts of a stack, so that its frames are asked once. */
struct known {
    const char *line, *function;
};

/* What was found between two stacks, so that the program's code is read once. */
struct worked {
    int32_t before, after;
    const char *text;
};

struct places {
    const struct trace *t;
    void *texts, *worked; /* of tsearch */
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
    tdestroy(p->worked, free);
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

/* The function's name in the source: GCC calls parts of functions f.part.0, f.constprop.1 and the like. */
static const char *function_of(struct places *p, const struct trace_frame *f)
{
    return f ? places_text(p, "%.*s", (int)strcspn(f->function, "."), f->function) : places_text(p, "%s", "");
}

static const char *line_of(struct places *p, const struct trace_frame *f)
{
    const char *function = function_of(p, f);
    if (!f || !f->file)
        return function;
    const char *file = basename(f->file);
    return *function ? places_text(p, "%s:%d (%s)", file, f->line, function)
                     : places_text(p, "%s:%d", file, f->line);
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
        const struct trace_frame *f = trace_place(p->t, stack);
        k->line = line_of(p, f);
        k->function = function_of(p, f);
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

/* Were both calls made in one function? If that is called in between by another one, as a timer is, it takes
 * little of the work. */
static bool is_on_both_sides(struct places *p, int32_t before, int32_t after)
{
    return before != TRACE_NONE && places_function(p, before) == places_function(p, after);
}

static const char *join(struct places *p, const char *list, const char *name)
{
    return *list ? places_text(p, "%s or %s", list, name) : name;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

static const char *worker_between(struct places *p, int32_t before, int32_t after)
{
    struct trace_between x = trace_between(p->t, before, after);
    const char *in = x.in ? function_of(p, x.in) : "", *list = "";
    qsort(x.worked, (size_t)x.count, sizeof *x.worked, compare_names); /* one text for one set of functions */
    for (int i = 0; i < x.count; i++)
        list = join(p, list, places_text(p, "%.*s", (int)strcspn(x.worked[i], "."), x.worked[i]));
    if (x.count)
        return x.more ? join(p, list, "others") : list;
    if (after == TRACE_NONE) /* no call follows: the library's code, called by what had called NX last */
        return places_function(p, before);
    return *in && is_on_both_sides(p, before, after) ? in : places_function(p, after);
}

static int compare_worked(const void *a, const void *b)
{
    const struct worked *x = a, *y = b;
    return x->before != y->before ? (x->before < y->before ? -1 : 1)
                                  : (x->after > y->after) - (x->after < y->after);
}

const char *places_worker(struct places *p, int32_t before, int32_t seen, int32_t after)
{
    if (seen != TRACE_NONE)
        return places_function(p, seen);
    struct worked key = {before, after, NULL};
    struct worked **found = tfind(&key, &p->worked, compare_worked);
    if (found)
        return (*found)->text;
    struct worked *w = xmalloc(sizeof *w);
    *w = key;
    w->text = worker_between(p, before, after);
    xchecked(tsearch(w, &p->worked, compare_worked));
    return w->text;
}

const char *places_call(struct places *p, int32_t call)
{
    const struct trace_call *c = &p->t->calls[call];
    const char *line = places_line(p, c->stack);
    return places_text(p, *line ? "%s at %s" : "%s%s", trace_called_name(p->t, c), line);
}
