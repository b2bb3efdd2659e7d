/* page_texts.c - see page_texts.h. */
#include "lab/page/page_texts.h"
#include <stdlib.h>
#include <string.h>
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/trace/program_places.h"
#include "observe/json_file.h"

struct page_texts {
    const struct trace *t;
    struct places *functions;
    json_t *numbers; /* the number of each text */
    json_t *list;
    int32_t *places; /* of each stack: its text's number */
    int32_t *called; /* of each call */
    int32_t stacks;  /* how many */
};

/* The number of a text, a new one if it was not there. */
static int32_t number_of(struct page_texts *p, const char *text)
{
    json_t *string = json_text(text), *known = json_object_get(p->numbers, json_string_value(string));
    if (known) {
        json_decref(string);
        return (int32_t)json_integer_value(known);
    }
    int32_t number = (int32_t)json_array_size(p->list);
    json_set(p->numbers, json_string_value(string), json_integer(number));
    json_append(p->list, string);
    return number;
}

static int32_t place_number(struct page_texts *p, int32_t stack)
{
    const struct trace_frame *f = trace_place(p->t, stack);
    if (!f || (!*f->function && !f->file))
        return TRACE_NONE;
    char *text = f->file && f->line ? xasprintf("%s, %s:%d", f->function, basename(f->file), f->line)
                                    : xstrdup(f->function);
    int32_t number = number_of(p, text);
    free(text);
    return number;
}

/* Looks the stack's place up, unless that was done before. */
static void look_up(struct page_texts *p, int32_t stack)
{
    enum { UNKNOWN = -2 };
    if (stack < 0)
        return;
    if (stack >= p->stacks) {
        int32_t room = stack * 2 + 64;
        p->places = xreallocarray(p->places, (size_t)room, sizeof *p->places);
        for (; p->stacks < room; p->stacks++)
            p->places[p->stacks] = UNKNOWN;
    }
    if (p->places[stack] == UNKNOWN)
        p->places[stack] = place_number(p, stack);
}

struct page_texts *page_texts_new(const struct trace *t)
{
    struct page_texts *p = xcalloc(1, sizeof *p);
    *p = (struct page_texts){
        .t = t, .functions = places_new(t), .numbers = json_object(), .list = json_array()};
    p->called = xcalloc((size_t)t->call_count + 1, sizeof *p->called);
    for (int32_t i = 0; i < t->call_count; i++) {
        p->called[i] = number_of(p, trace_called_name(t, &t->calls[i]));
        look_up(p, t->calls[i].stack);
    }
    for (int32_t i = 0; i < t->handler_count; i++)
        look_up(p, t->handlers[i].stack);
    return p;
}

void page_texts_free(struct page_texts *p)
{
    places_free(p->functions);
    json_decref(p->numbers);
    json_decref(p->list);
    free(p->places);
    free(p->called);
    free(p);
}

int32_t page_texts_called(const struct page_texts *p, const struct trace_call *c)
{
    return p->called[c - p->t->calls];
}

int32_t page_texts_place(const struct page_texts *p, int32_t stack)
{
    return stack < 0 ? TRACE_NONE : p->places[stack];
}

int32_t page_texts_worked(struct page_texts *p, const struct trace_around *around)
{
    const char *text = places_worker(p->functions, around->before, around->seen, around->after);
    return *text ? number_of(p, text) : TRACE_NONE;
}

json_t *page_texts_json(const struct page_texts *p)
{
    return json_incref(p->list);
}
