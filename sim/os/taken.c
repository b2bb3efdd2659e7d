/* taken.c - see taken.h. */
#include "os/taken.h"
#include "kernel/xalloc.h"

static struct taken *next(struct taken_ring *r)
{
    struct taken *t = &r->last[r->count++ % TAKEN_MOST];
    *t = (struct taken){0};
    return t;
}

static struct taken_log *log_of(struct node *n)
{
    if (!n->cold->taken)
        n->cold->taken = xcalloc(1, sizeof *n->cold->taken);
    return n->cold->taken;
}

static void fill(struct taken *t, enum taken_how how, const struct message *m, vtime came)
{
    t->how = how;
    t->type = m->type, t->pid = m->pid, t->source = m->source, t->bytes = m->bytes;
    t->came = came;
}

/* The calls of the program that are under way, from a frame of this program outwards. */
static void note_calls(const struct node *n, uintptr_t at[], const uintptr_t *frame)
{
    enum { MOST_FRAMES = 24 };
    int found = 0;
    for (int i = 0; i < MOST_FRAMES && found < TAKEN_CALLS; i++) {
        if (frame[1] - (uintptr_t)n->program < n->image_bytes)
            at[found++] = frame[1];
        if (frame[0] <= (uintptr_t)frame || frame[0] >= (uintptr_t)n->stack + n->stack_bytes)
            return;
        frame = (const uintptr_t *)frame[0];
    }
}

void taken_note(struct node *n, const struct receive *r, const struct message *m)
{
    struct taken *t = next(&log_of(n)->by_program);
    fill(t, r->handler ? TAKEN_BY_HANDLER : TAKEN_BY_RECEIVE, m, m->complete);
    t->by = r->select;
    t->call = r->handler ? "hrecv" : n->call;
    if (r->handler)
        t->at[0] = (uintptr_t)r->handler + 1; /* as if a call in its first instruction returned */
    else
        note_calls(n, t->at, __builtin_frame_address(0));
}

void taken_note_loss(struct node *n, const struct message *m, enum taken_how how, vtime now)
{
    struct taken *t = next(&log_of(n)->lost);
    fill(t, how, m, m->arrived ? m->complete : now);
    t->by = (struct selector){-1, -1, -1};
}

const struct taken *taken_get(const struct taken_ring *r, uint32_t k)
{
    uint32_t kept = r->count < TAKEN_MOST ? r->count : TAKEN_MOST;
    return k < kept ? &r->last[(r->count - kept + k) % TAKEN_MOST] : NULL;
}
