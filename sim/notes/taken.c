/* taken.c - see taken.h. */
#include "notes/taken.h"
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "os/observer.h"

struct taken_note {
    struct observer observer; /* first */
    struct taken_log *log;    /* NULL: nothing has been noted */
};

static struct taken_note *note_of(struct observer *o)
{
    return (struct taken_note *)o;
}

static struct taken *next(struct taken_ring *r)
{
    struct taken *t = &r->last[r->count++ % TAKEN_MOST];
    *t = (struct taken){0};
    return t;
}

static struct taken_log *log_of(struct observer *o)
{
    struct taken_note *own = note_of(o);
    if (!own->log)
        own->log = xcalloc(1, sizeof *own->log);
    return own->log;
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
        if (frame[1] - (uintptr_t)n->guest.program < n->guest.image_bytes)
            at[found++] = frame[1];
        if (frame[0] <= (uintptr_t)frame || frame[0] >= (uintptr_t)n->guest.stack + n->guest.stack_bytes)
            return;
        frame = (const uintptr_t *)frame[0];
    }
}

static void hear_posts_special(struct observer *o, struct node *n, const struct receive *r);
static void hear_takes_special(struct observer *o, struct node *n, const struct receive *r);
static void hear_loses(struct observer *o, struct node *n, const struct message *m, bool flushed, vtime t);

/* Of a program all of whose receives are of one type each nothing is noted when it takes a message. Then, and
 * when a receive has selected a certain sender. */
static const struct announcements at_first = {.posts_special = hear_posts_special, .loses = hear_loses};
static const struct announcements then = {
    .posts_special = hear_posts_special, .takes_special = hear_takes_special, .loses = hear_loses};
static const struct announcements named = {.takes_special = hear_takes_special, .loses = hear_loses};

static void hear_posts_special(struct observer *o, struct node *n, const struct receive *r)
{
    const struct announcements *wanted = r->select.node >= 0 ? &named : &then;
    if (o->hears != wanted)
        observer_wants(n, o, wanted);
}

/* May a message that r takes have been meant for another receive? */
static bool matters(const struct observer *o, const struct receive *r)
{
    return r->select.type < 0 || r->handler || (o->hears == &named && r->select.node < 0);
}

static void hear_takes_special(struct observer *o, struct node *n, const struct receive *r)
{
    if (!matters(o, r))
        return;
    struct taken *t = next(&log_of(o)->by_program);
    fill(t, r->handler ? TAKEN_BY_HANDLER : TAKEN_BY_RECEIVE, r->m, r->m->complete);
    t->by = r->select;
    t->call = r->handler ? "hrecv" : n->call.name;
    if (r->handler)
        t->at[0] = (uintptr_t)r->handler + 1; /* as if a call in its first instruction returned */
    else
        note_calls(n, t->at, __builtin_frame_address(0));
}

static void hear_loses(struct observer *o, struct node *n, const struct message *m, bool flushed, vtime t)
{
    (void)n;
    struct taken *lost = next(&log_of(o)->lost);
    fill(lost, flushed ? TAKEN_BY_FLUSH : TAKEN_AS_FORCED, m, m->arrived ? m->complete : t);
    lost->by = (struct selector){-1, -1, -1};
}

static struct observer *observer_at(const struct node *n)
{
    static const struct announcements *const kinds[] = {&at_first, &then, &named};
    struct observer *o = NULL;
    for (size_t i = 0; !o && i < sizeof kinds / sizeof *kinds; i++)
        o = observer_of(n, kinds[i]);
    return o;
}

void taken_begin(struct node *n)
{
    struct taken_note *own = xcalloc(1, sizeof *own);
    own->observer.hears = &at_first;
    observer_add(n, &own->observer);
}

void taken_end(struct node *n)
{
    struct observer *o = observer_at(n);
    if (!o)
        return;
    observer_remove(n, o);
    free(note_of(o)->log);
    free(o);
}

const struct taken_log *taken_of(const struct node *n)
{
    struct observer *o = observer_at(n);
    return o ? note_of(o)->log : NULL;
}

const struct taken *taken_get(const struct taken_ring *r, uint32_t k)
{
    uint32_t kept = r->count < TAKEN_MOST ? r->count : TAKEN_MOST;
    return k < kept ? &r->last[(r->count - kept + k) % TAKEN_MOST] : NULL;
}
