/* path_times.c - see path_times.h. */
#include "os/path_times.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "node/self.h"

void path_times_begin(struct node *n)
{
    if (n->image->bodies_begin == n->image->bodies_end)
        return;
    n->path_times = xcalloc(1, sizeof *n->path_times);
    n->path_times->handlers.recent = n->image->root;
}

void path_times_end(struct node *n)
{
    struct node_path_times *p = n->path_times;
    if (!p)
        return;
    for (struct nxc_path *next; p->made; p->made = next) {
        next = p->made->older;
        free(p->made);
    }
    free(p->list);
    free(p);
    n->path_times = NULL;
}

/* Called by programs: the paths outlive them. */
struct nxc_path *node_nxc_new_path(int64_t counts);
struct nxc_path *node_nxc_new_path(int64_t counts)
{
    struct node_path_times *p = node_self()->path_times;
    struct nxc_path *path = xcalloc(1, sizeof *path + (size_t)counts * sizeof path->counts[0]);
    path->older = p->made;
    return p->made = path;
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

void path_times_add(struct node *n, vtime system, vtime idle)
{
    struct node_path_times *p = n->path_times;
    const struct nxc_path *path = p->charged ? p->charged : *n->image->path;
    const char *call = p->charged ? p->charged_call : n->call;
    struct path_time *e = at(p, path, path == &p->handlers ? "(interrupt)" : call ? call : "(system)");
    e->system += system;
    e->idle += idle;
}

void path_times_add_interrupt(struct node *n, vtime system)
{
    at(n->path_times, NULL, "(interrupts)")->system += system;
}

const struct nxc_path *path_times_now(const struct node *n)
{
    return *n->image->path;
}

void path_times_charge(struct node *n, const struct nxc_path *path, const char *call)
{
    n->path_times->charged = path, n->path_times->charged_call = call;
}

void path_times_charge_program(struct node *n)
{
    n->path_times->charged = NULL;
}

struct nxc_path *path_times_handler_begins(struct node *n)
{
    struct nxc_path *before = *n->image->path;
    *n->image->path = &n->path_times->handlers;
    return before;
}

void path_times_handler_ends(struct node *n, struct nxc_path *before)
{
    *n->image->path = before;
}
