/* directory.c - see directory.h. */
#include "cfs/directory.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

enum { LETTER = 96 }; /* bytes of a request or answer: a name and some numbers, short enough to go at once */

struct directory {
    struct protocol *protocol;
    struct evq *q;
    uint32_t address;
    vtime free_at;
    uint64_t served;
};

struct directory *directory_new(struct protocol *p, struct evq *q, uint32_t address)
{
    struct directory *d = xcalloc(1, sizeof *d);
    d->protocol = p, d->q = q, d->address = address;
    return d;
}

void directory_free(struct directory *d)
{
    free(d);
}

vtime directory_work(struct directory *d, vtime at, vtime t)
{
    return d->free_at = vt_max(at, d->free_at) + t;
}

static void answer_comes(struct parcel *p, vtime at, vtime now)
{
    struct dir_request *r = (struct dir_request *)p;
    r->answered(r, at, now);
}

void directory_answer(struct directory *d, struct dir_request *r, vtime now)
{
    vtime ready = directory_work(d, now, post_send_time(d->protocol, POST_EAGER, LETTER));
    r->parcel.arrived = answer_comes;
    post_send(d->protocol, d->address, r->node, POST_EAGER, LETTER, &r->parcel, ready);
}

static void serve(void *ctx, void *arg, vtime now)
{
    struct directory *d = ctx;
    struct dir_request *r = arg;
    d->served++;
    if (r->serve(r, now))
        directory_answer(d, r, now);
}

static void request_comes(struct parcel *p, vtime at, vtime now)
{
    struct dir_request *r = (struct dir_request *)p;
    (void)now;
    evq_put(r->directory->q, directory_work(r->directory, at, r->takes), r->directory->address, serve,
            r->directory, r);
}

vtime directory_ask_time(const struct directory *d)
{
    return post_send_time(d->protocol, POST_EAGER, LETTER);
}

void directory_ask(struct directory *d, struct dir_request *r, vtime at)
{
    r->directory = d;
    r->next = NULL;
    r->parcel = (struct parcel){.arrived = request_comes};
    post_send(d->protocol, r->node, d->address, POST_EAGER, LETTER, &r->parcel, at);
}

uint64_t directory_served(const struct directory *d)
{
    return d->served;
}
