/* path_times.c - see path_times.h. */
#include "profile/path_times.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "node/self.h"

static struct node_path_times *times_of(struct observer *o)
{
    return (struct node_path_times *)o;
}

/* Most names of one call are one text, so comparing addresses settles most cases. */
static struct path_time *at(struct node_path_times *p, const struct nxc_path *path, const char *call)
{
    for (size_t i = 0; i < p->count; i++) {
        struct path_time *e = &p->list[i];
        if (e->path == path && (e->call == call || strcmp(e->call, call) == 0))
            return e;
    }
    if (p->count == p->room) {
        p->room = p->room ? 2 * p->room : 16;
        p->list = xreallocarray(p->list, p->room, sizeof *p->list);
    }
    p->list[p->count] = (struct path_time){.path = path, .call = call};
    return &p->list[p->count++];
}

/* For the call that is charged, or the one that the program is in, on the path where the program is. */
static void hear_charged(struct observer *o, struct node *n, vtime system, vtime idle, bool computes)
{
    struct node_path_times *p = times_of(o);
    if (computes) {
        at(p, NULL, "(interrupts)")->system += system;
        return;
    }
    const struct nxc_path *path = p->charged ? p->charged : *n->guest.image->path;
    const char *call = p->charged ? p->charged_call : n->call.name;
    struct path_time *e = at(p, path, path == &p->handlers ? "(interrupt)" : call ? call : "(system)");
    e->system += system;
    e->idle += idle;
}

/* --- deferred calls --- */

static uint32_t index_of(const struct node *n, uint32_t i)
{
    return (n->deferred.first + i) % DEFERRED_MOST;
}

static void hear_deferred(struct observer *o, struct node *n)
{
    times_of(o)->deferred[index_of(n, n->deferred.count - 1)] = *n->guest.image->path;
}

static void hear_charges_deferred(struct observer *o, struct node *n, uint32_t i)
{
    struct node_path_times *p = times_of(o);
    p->charged = p->deferred[index_of(n, i)], p->charged_call = n->calls[index_of(n, i)].name;
}

static void hear_charges_program(struct observer *o, struct node *n)
{
    (void)n;
    times_of(o)->charged = NULL;
}

/* --- handlers --- */

static void hear_handler_begins(struct observer *o, struct node *n, const struct due *d)
{
    (void)d;
    times_of(o)->interrupted = *n->guest.image->path;
    *n->guest.image->path = &times_of(o)->handlers;
}

static void hear_handler_ends(struct observer *o, struct node *n)
{
    *n->guest.image->path = times_of(o)->interrupted;
}

/* --- the observer --- */

static const struct announcements heard = {.charged = hear_charged,
                                           .deferred = hear_deferred,
                                           .charges_deferred = hear_charges_deferred,
                                           .charges_program = hear_charges_program,
                                           .handler_begins = hear_handler_begins,
                                           .handler_ends = hear_handler_ends};

void path_times_begin(struct node *n)
{
    if (n->guest.image->bodies_begin == n->guest.image->bodies_end)
        return;
    struct node_path_times *p = xcalloc(1, sizeof *p);
    p->observer.hears = &heard;
    p->handlers.recent = n->guest.image->root;
    observer_add(n, &p->observer);
}

void path_times_end(struct node *n)
{
    struct observer *o = observer_of(n, &heard);
    if (!o)
        return;
    observer_remove(n, o);
    struct node_path_times *p = times_of(o);
    for (struct nxc_path *next; p->made; p->made = next) {
        next = p->made->older;
        free(p->made);
    }
    free(p->list);
    free(p);
}

const struct node_path_times *path_times_of(const struct node *n)
{
    return (const struct node_path_times *)observer_of(n, &heard);
}

/* Called by programs: the paths outlive them. */
struct nxc_path *node_nxc_new_path(int64_t counts);
struct nxc_path *node_nxc_new_path(int64_t counts)
{
    struct node_path_times *p = times_of(observer_of(node_self(), &heard));
    struct nxc_path *path = xcalloc(1, sizeof *path + (size_t)counts * sizeof path->counts[0]);
    path->older = p->made;
    return p->made = path;
}
