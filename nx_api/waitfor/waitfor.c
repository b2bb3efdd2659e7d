/* waitfor.c - see waitfor.h: what a snapshot consists of. */
#include "nx_api/waitfor/waitfor.h"
#include <stdlib.h>
#include <string.h>
#include "nx_api/waitfor/waitfor_parts.h"

/* Texts that are kept. Equal texts that follow one another are one. */
struct waitfor_texts {
    char **all;
    size_t count;
};

void *waitfor_grow(void *block, size_t count, size_t bytes)
{
    void *p = reallocarray(block, count ? count : 1, bytes);
    if (!p)
        abort();
    return p;
}

void *waitfor_room(void *array, size_t count, size_t bytes)
{
    return count & (count - 1) ? array : waitfor_grow(array, 2 * count + 1, bytes);
}

void *waitfor_alloc(size_t count, size_t bytes)
{
    return memset(waitfor_grow(NULL, count, bytes), 0, count * bytes);
}

FILE *waitfor_stream(char **text, size_t *size)
{
    FILE *f = open_memstream(text, size);
    if (!f)
        abort();
    return f;
}

struct waitfor *waitfor_new(uint32_t count)
{
    struct waitfor *w = waitfor_alloc(1, sizeof *w);
    *w = (struct waitfor){.count = count, .clock = "virtual time"};
    w->nodes = waitfor_alloc(count, sizeof *w->nodes);
    w->texts = waitfor_alloc(1, sizeof *w->texts);
    for (uint32_t i = 0; i < count; i++) {
        char name[32];
        snprintf(name, sizeof name, "node %u", i);
        w->nodes[i] = (struct waitfor_node){.name = waitfor_text(w, name), .number = i};
    }
    return w;
}

void waitfor_free(struct waitfor *w)
{
    if (!w)
        return;
    for (uint32_t i = 0; i < w->count; i++) {
        struct waitfor_node *n = &w->nodes[i];
        free(n->stack);
        free(n->messages);
        free(n->receives);
        free(n->taken);
    }
    for (size_t i = 0; i < w->texts->count; i++)
        free(w->texts->all[i]);
    free(w->texts->all);
    free(w->texts);
    free(w->nodes);
    free(w->windows);
    free(w->cycle);
    free(w);
}

const char *waitfor_text(struct waitfor *w, const char *text)
{
    struct waitfor_texts *t = w->texts;
    if (!text)
        return NULL;
    if (t->count && strcmp(t->all[t->count - 1], text) == 0)
        return t->all[t->count - 1];
    t->all = waitfor_room(t->all, t->count, sizeof *t->all);
    size_t bytes = strlen(text) + 1;
    return t->all[t->count++] = memcpy(waitfor_alloc(bytes, 1), text, bytes);
}

void waitfor_add_message(struct waitfor_node *n, const struct waitfor_message *m)
{
    if (n->message_count == WAITFOR_MOST_MESSAGES) {
        n->more_messages++;
        return;
    }
    n->messages = waitfor_room(n->messages, n->message_count, sizeof *m);
    n->messages[n->message_count++] = *m;
}

void waitfor_add_receive(struct waitfor_node *n, const struct waitfor_receive *r)
{
    n->receives = waitfor_room(n->receives, n->receive_count, sizeof *r);
    n->receives[n->receive_count++] = *r;
}

void waitfor_add_taken(struct waitfor_node *n, const struct waitfor_taken *t)
{
    n->taken = waitfor_room(n->taken, n->taken_count, sizeof *t);
    n->taken[n->taken_count++] = *t;
}

/* (There are few.) */
void waitfor_add_window(struct waitfor *w, long context, const char *name)
{
    for (size_t i = 0; i < w->window_count; i++)
        if (w->windows[i].context == context)
            return;
    w->windows = waitfor_room(w->windows, w->window_count, sizeof *w->windows);
    w->windows[w->window_count++] = (struct waitfor_window){context, waitfor_text(w, name)};
}

void waitfor_add_frame(struct waitfor *w, struct waitfor_node *n, const char *line)
{
    n->stack = waitfor_room(n->stack, n->stack_count, sizeof *n->stack);
    n->stack[n->stack_count++] = waitfor_text(w, line);
}
