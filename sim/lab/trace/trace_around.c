/* trace_around.c - where the program was before and behind a piece of its node: see trace_model.h. */
#include "lab/trace/trace_model.h"

/* Are the piece and the next one of one handler, or both of none? */
static bool go_together(const struct trace_piece *p)
{
    return p[0].in_handler == p[1].in_handler && (!p[0].in_handler || p[0].handler == p[1].handler);
}

static void find_before(const struct trace *t, const struct trace_piece *list, size_t count,
                        struct trace_around *around)
{
    int32_t program = TRACE_NONE, handler = TRACE_NONE;
    for (size_t i = 0; i < count; i++) {
        const struct trace_piece *p = &list[i];
        if (i > 0 && !go_together(p - 1))
            handler = TRACE_NONE;
        int32_t *last = p->in_handler ? &handler : &program;
        around[i].before = *last;
        if (p->call != TRACE_NONE)
            *last = t->calls[p->call].stack;
    }
}

static void find_after(const struct trace *t, const struct trace_piece *list, size_t count,
                       struct trace_around *around)
{
    for (size_t i = count; i-- > 0;) {
        const struct trace_piece *p = &list[i];
        if (p->call != TRACE_NONE)
            around[i].after = t->calls[p->call].stack;
        else if (i + 1 < count && go_together(p))
            around[i].after = around[i + 1].after;
        else if (p->in_handler)
            around[i].after = around[i].before;
        else
            around[i].after = i + 1 < count ? t->handlers[p[1].handler].stack : TRACE_NONE;
    }
}

/* Where the handler interrupted the program that runs on the given side of piece i, but for what the system
 * does between the two; TRACE_NONE: none does. */
static int32_t interrupted_at(const struct trace *t, const struct trace_piece *list, size_t count, size_t i,
                              int side)
{
    const struct trace_piece *p = &list[i], *q = p;
    do {
        if (q == (side < 0 ? list : list + count - 1))
            return TRACE_NONE;
        q += side;
    } while (q->state == TRACE_IN_SYSTEM && !q->in_handler && q->call == TRACE_NONE);
    bool other = q->in_handler && (!p->in_handler || q->handler != p->handler);
    return other ? t->handlers[q->handler].stack : TRACE_NONE;
}

void trace_around(const struct trace *t, const struct trace_piece *list, size_t count,
                  struct trace_around *around)
{
    find_before(t, list, count, around);
    find_after(t, list, count, around);
    for (size_t i = 0; i < count; i++) {
        around[i].seen = TRACE_NONE;
        for (int side = -1; side <= 1 && list[i].state == TRACE_COMPUTING; side += 2)
            if (around[i].seen == TRACE_NONE)
                around[i].seen = interrupted_at(t, list, count, i, side);
    }
}
