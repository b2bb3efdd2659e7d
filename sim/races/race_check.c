/* race_check.c - see race_check.h. */
#include "races/race_check.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "races/node_races.h"
#include "races/race_mpi.h"
#include "nx_api/contract/program_image.h"

struct races *races_new(void)
{
    struct races *r = xcalloc(1, sizeof *r);
    r->last = &r->nodes;
    return r;
}

static void free_parts(struct node_races *r)
{
    race_restored_give_up(&r->restored, &r->findings);
    race_restored_free(&r->restored);
    race_clock_free(r->main.heard);
    race_clock_free(r->handlers.heard);
    r->main.heard = r->handlers.heard = NULL;
    race_shadow_free(r->shadow);
    r->shadow = NULL;
    race_flights_end(&r->flights);
}

void races_free(struct races *all)
{
    if (!all)
        return;
    for (struct node_races *r = all->nodes, *next; r; r = next) {
        next = r->next;
        free_parts(r);
        race_places_free(r->places);
        race_findings_end(&r->findings);
        free(r);
    }
    for (struct race_stamp *s = all->stamps, *next; s; s = next) { /* of messages that nobody has freed */
        next = s->next;
        race_clock_free(s->heard);
        free(s);
    }
    free(all);
}

void races_begin(struct races *all, struct node *n)
{
    if (!n->guest.image->races || n->asan)
        return;
    struct node_races *r = xcalloc(1, sizeof *r);
    r->observer.hears = &race_observer, r->library.hears = &race_mpi_observer;
    r->all = all;
    r->file = n->guest.file;
    r->number = n->is_host ? 0 : n->id + 1;
    memcpy(r->name, n->cold->name, sizeof r->name);
    r->on = n->guest.image->races->on;
    r->sites_begin = (uint32_t)((uintptr_t)n->guest.image->races->sites_begin - (uintptr_t)n->guest.program);
    r->sites_end = (uint32_t)((uintptr_t)n->guest.image->races->sites_end - (uintptr_t)n->guest.program);
    r->main.epoch = 1;
    r->stack_low = UINTPTR_MAX;
    r->shadow = race_shadow_new();
    r->places = race_places_new();
    *all->last = r;
    all->last = &r->next;
    observer_add(n, &r->observer);
    observer_add(n, &r->library);
}

void races_over(struct races *all)
{
    for (struct node_races *r = all->nodes; r; r = r->next)
        race_restored_give_up(&r->restored, &r->findings);
}

void races_end(struct node *n)
{
    struct node_races *r = races_of(n);
    if (!r)
        return;
    observer_remove(n, &r->observer);
    observer_remove(n, &r->library);
    free_parts(r);
    r->gone = true;
}

void races_succeed(struct node *n, const struct node *before)
{
    struct node_races *r = races_of(n);
    const struct node_races *old = races_of(before);
    if (!r || !old)
        return;
    r->main.epoch = old->main.epoch + 1;
    r->handlers.run = old->handlers.run;
    r->main.knows = r->handlers.run; /* of another program's handlers nothing is left */
}
