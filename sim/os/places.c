/* places.c - see places.h. */
#include "os/places.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "node/self.h"

void places_begin(struct node *n)
{
    if (n->image->bodies_begin == n->image->bodies_end)
        return;
    n->places = xcalloc(1, sizeof *n->places);
    n->places->handlers.recent = n->image->root;
}

void places_end(struct node *n)
{
    struct node_places *p = n->places;
    if (!p)
        return;
    for (struct nxc_path *next; p->made; p->made = next) {
        next = p->made->older;
        free(p->made);
    }
    free(p->list);
    free(p);
    n->places = NULL;
}

/* Called by programs: the paths outlive them. */
struct nxc_path *node_nxc_new_path(int64_t counts);
struct nxc_path *node_nxc_new_path(int64_t counts)
{
    struct node_places *p = node_self()->places;
    struct nxc_path *path = xcalloc(1, sizeof *path + (size_t)counts * sizeof path->counts[0]);
    path->older = p->made;
    return p->made = path;
}

/* Most names of one call are one text, so comparing addresses settles most cases. */
static struct place *at(struct node_places *p, const struct nxc_path *path, const char *call)
{
    for (size_t i = 0; i < p->count; i++) {
        struct place *e = &p->list[i];
        if (e->path == path && (e->call == call || strcmp(e->call, call) == 0))
            return e;
    }
    if (p->count == p->room) {
        p->room = p->room ? 2 * p->room : 16;
        p->list = xreallocarray(p->list, p->room, sizeof *p->list);
    }
    p->list[p->count] = (struct place){.path = path, .call = call};
    return &p->list[p->count++];
}

void places_add(struct node *n, vtime system, vtime idle)
{
    struct node_places *p = n->places;
    const struct nxc_path *path = p->charged ? p->charged : *n->image->path;
    const char *call = p->charged ? p->charged_call : n->call;
    struct place *e = at(p, path, path == &p->handlers ? "(interrupt)" : call ? call : "(system)");
    e->system += system;
    e->idle += idle;
}

void places_add_interrupt(struct node *n, vtime system)
{
    at(n->places, NULL, "(interrupts)")->system += system;
}

const struct nxc_path *places_now(const struct node *n)
{
    return *n->image->path;
}

void places_charge(struct node *n, const struct nxc_path *path, const char *call)
{
    n->places->charged = path, n->places->charged_call = call;
}

void places_charge_program(struct node *n)
{
    n->places->charged = NULL;
}

struct nxc_path *places_handler_begins(struct node *n)
{
    struct nxc_path *before = *n->image->path;
    *n->image->path = &n->places->handlers;
    return before;
}

void places_handler_ends(struct node *n, struct nxc_path *before)
{
    *n->image->path = before;
}
