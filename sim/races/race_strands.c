/* race_strands.c - what orders a node's two strands: as observed (os/observer.h). See node_races.h. */
#include <stdlib.h>
#include <string.h>
#include "kernel/crossing.h"
#include "kernel/xalloc.h"
#include "node/system.h"
#include "net/protocol.h"
#include "os/due.h"
#include "os/order.h"
#include "races/node_races.h"

/* --- epochs --- */

static struct race_moment *slot(struct race_moment *ring, uint64_t epoch)
{
    return &ring[epoch % RACE_MOMENTS];
}

static const uint64_t LAST_EPOCH = (UINT64_C(1) << RACE_EPOCH_BITS) - 1;

/* (17 thousand million epochs take longer than anybody waits; what comes then is taken for one epoch.) */
uint64_t race_main_epoch(struct node_races *r)
{
    if (r->main.released && r->main.epoch < LAST_EPOCH) {
        r->main.epoch++;
        *slot(r->main_moments, r->main.epoch) = (struct race_moment){r->main.epoch, r->since, 0};
    }
    r->main.released = false;
    return r->main.epoch;
}

vtime race_main_moment(const struct node_races *r, uint64_t epoch)
{
    const struct race_moment *m = &r->main_moments[epoch % RACE_MOMENTS];
    return m->epoch == epoch ? m->at : VT_NEVER;
}

vtime race_run_moment(const struct node_races *r, uint64_t run)
{
    const struct race_moment *m = &r->runs[run % RACE_MOMENTS];
    return m->epoch == run ? m->at : VT_NEVER;
}

static void begin_run(struct node_races *r, vtime now)
{
    r->handlers.run++;
    struct race_moment *m = slot(r->runs, r->handlers.run);
    r->older_knows = m->knows > r->older_knows ? m->knows : r->older_knows;
    *m = (struct race_moment){r->handlers.run, now, r->handlers.knows};
}

static struct node_races *checker(struct observer *o)
{
    return (struct node_races *)o;
}

/* --- are accesses to be told? --- */

void race_set_on(struct node *n)
{
    struct node_races *r = races_of(n);
    bool tracks = n->mailbox.handlers || r->handlers.runs || r->main.knows < r->handlers.run;
    if (r->tracks && !tracks) {
        race_shadow_clear(r->shadow);
        r->stack_low = UINTPTR_MAX;
    }
    r->tracks = tracks;
    *r->on = tracks || r->flights.count;
}

static void hear_call_ends(struct observer *by, struct node *n)
{
    checker(by)->since = node_now(n);
    race_findings_begin_segment(&checker(by)->findings);
    race_set_on(n);
}

/* The program is stopped while it computes: how far ahead of the end it has come, depends on the engine and
 * its threads. Not so at the limit of time, which nobody passes, and where the program itself has failed. */
static void hear_ends(struct observer *by, struct node *n, vtime t)
{
    struct node_races *r = checker(by);
    const struct schedule *s = &n->sys->schedule;
    bool in_call = n->call.name && n->call.since < t;
    bool fails = s->stop == STOP_FAILED && s->stop_at.address == n->lp.address;
    if (!n->end.cut_short || in_call || fails || s->stop == STOP_VIRTUAL_TIME)
        return;
    race_findings_forget_segment(&r->findings);
    race_restored_forget(&r->restored);
}

/* --- hearing --- */

static void main_hears(struct node_races *r, uint64_t run)
{
    r->main.knows = run > r->main.knows ? run : r->main.knows;
}

static void handler_hears(struct node_races *r, uint64_t epoch)
{
    if (epoch <= r->handlers.knows)
        return;
    r->handlers.knows = epoch;
    slot(r->runs, r->handlers.run)->knows = epoch;
}

void race_main_hears_run(struct node_races *r, uint64_t run)
{
    main_hears(r, run);
    race_clock_join(&r->main.heard, r->handlers.heard);
}

void race_handler_hears_main(struct node_races *r, uint64_t epoch)
{
    handler_hears(r, epoch);
    race_clock_join(&r->handlers.heard, r->main.heard);
}

void race_handler_hears_run(struct node_races *r, uint64_t run)
{
    const struct race_moment *m = &r->runs[run % RACE_MOMENTS];
    handler_hears(r, m->epoch == run ? m->knows : r->older_knows);
}

void race_hear(struct node_races *r, uint32_t node, struct race_known known, const struct race_clock *heard)
{
    struct race_known own = node == r->number ? known : race_clock_of(heard, r->number);
    struct race_clock **mine = r->handlers.runs ? &r->handlers.heard : &r->main.heard;
    race_clock_join(mine, heard);
    if (node != r->number)
        race_clock_hear(mine, node, known);
    if (r->handlers.runs) {
        handler_hears(r, own.main);
        r->handlers.told = own.main > r->handlers.told ? own.main : r->handlers.told;
    } else
        main_hears(r, own.handlers);
}

/* --- sending --- */

/* What the strand that runs is, and has heard of the other. */
static struct race_known now(struct node_races *r)
{
    if (r->handlers.runs)
        return (struct race_known){r->handlers.knows, r->handlers.run};
    struct race_known k = {race_main_epoch(r), r->main.knows};
    r->main.released = true;
    return k;
}

static struct race_clock *heard(const struct node_races *r)
{
    return race_clock_share(r->handlers.runs ? r->handlers.heard : r->main.heard);
}

static void end_stamp(struct protocol_cargo *cargo)
{
    struct race_stamp *s = (struct race_stamp *)cargo;
    *s->link = s->next;
    if (s->next)
        s->next->link = s->link;
    race_clock_free(s->heard);
    free(s);
}

static struct race_stamp *new_stamp(struct node_races *r)
{
    struct race_stamp *s = xcalloc(1, sizeof *s);
    *s = (struct race_stamp){{0, end_stamp}, r->all, r->all->stamps, &r->all->stamps,
                             r->number,      now(r), heard(r)};
    if (s->next)
        s->next->link = &s->next;
    return r->all->stamps = s;
}

/* Can anybody learn anything from the node? */
static bool knows_something(const struct node_races *r)
{
    return r->tracks || r->handlers.run || r->main.heard;
}

void race_take_off(struct node *n, struct race_flight *f)
{
    struct node_races *r = races_of(n);
    f->by_handler = r->handlers.runs;
    f->began = n->call.name ? node_now(n) : r->since;
    f->now = now(r);
    f->heard = heard(r);
    race_flights_add(&r->flights, f);
    race_set_on(n);
}

/* Of a call of NX. */
static void take_off(struct node *n, const void *key, const void *buf, size_t bytes, bool receives,
                     uint32_t place)
{
    uintptr_t begin = (uintptr_t)buf;
    race_take_off(n, &(struct race_flight){.key = key,
                                           .begin = begin,
                                           .end = begin + bytes,
                                           .receives = receives,
                                           .place = place,
                                           .call = n->call.name});
}

static void land(struct node *n, const void *key)
{
    struct race_flight f;
    if (!race_flights_remove(&races_of(n)->flights, key, &f))
        return;
    race_clock_free(f.heard);
    race_set_on(n);
}

static void hear_sends(struct observer *by, struct node *n, const struct observed_send *what)
{
    struct node_races *r = checker(by);
    const struct send *s = what->s;
    uintptr_t buf = (uintptr_t)what->buf;
    bool lasts = s && s != &n->cold->own.send[0] && s != &n->cold->own.send[1];
    race_set_on(n);
    if (what->first && knows_something(r))
        protocol_carry(what->first, &new_stamp(r)->cargo);
    if (r->in_library)
        return;
    uint32_t place = *r->on || lasts ? race_place_in_call(n, n->call.name, __builtin_frame_address(0)) : 0;
    race_buffer_in_call(n, buf, what->bytes, false, place);
    race_access_in_call(n, buf, what->bytes, false, place);
    if (lasts)
        take_off(n, s, what->buf, what->bytes, false, place);
}

static void hear_sent(struct observer *by, struct node *n, const struct send *s)
{
    (void)by;
    land(n, s);
}

/* --- receiving --- */

static void hear_posts(struct observer *by, struct node *n, struct receive *r)
{
    if (checker(by)->in_library)
        return;
    uint32_t place = race_place_in_call(n, n->call.name, __builtin_frame_address(0));
    race_buffer_in_call(n, (uintptr_t)r->buf, r->room, true, place);
    take_off(n, r, r->buf, r->room, true, place);
}

static void hear_withdraws(struct observer *by, struct node *n, struct receive *r)
{
    (void)by;
    land(n, r);
}

static void hear_takes(struct observer *by, struct node *n, struct receive *r)
{
    struct node_races *c = checker(by);
    const struct message *m = r->m;
    uint32_t place;
    if (m->carries) {
        const struct race_stamp *s = (const struct race_stamp *)m->cargo;
        race_hear(c, s->node, s->known, s->heard);
    }
    land(n, r);
    if (c->in_library || !c->tracks || m->bytes > r->room)
        return;
    if (r->handler)
        place = race_places_of_handler(c->places, c->handlers.call, c->handlers.posted);
    else
        place = race_place_in_call(n, n->call.name, __builtin_frame_address(0));
    race_access_in_call(n, (uintptr_t)r->buf, m->bytes, true, place);
}

/* --- handlers --- */

static void hear_handler_begins(struct observer *by, struct node *n, const struct due *d)
{
    struct node_races *c = checker(by);
    struct race_flight f = {0};
    race_restored_give_up(&c->restored, &c->findings); /* the last was left by longjmp */
    race_flights_remove(&c->flights, d->receive ? (const void *)d->receive : d->send, &f);
    c->handlers.runs = true;
    c->handlers.knows = c->handlers.told = f.now.main;
    memset(c->handlers.read, 0, sizeof c->handlers.read);
    c->handlers.posted = f.place, c->handlers.call = f.call;
    c->handlers.frame = crossing_stack_pointer();
    begin_run(c, node_now(n));
    race_clock_join(&c->handlers.heard, f.heard);
    race_clock_free(f.heard);
    race_findings_begin_segment(&c->findings);
    race_set_on(n);
}

static void hear_handler_ends(struct observer *by, struct node *n)
{
    struct node_races *r = checker(by);
    race_restored_run_ends(r, n);
    r->handlers.runs = false;
    r->main.released = true;
    r->since = node_now(n);
    race_findings_begin_segment(&r->findings);
    race_set_on(n);
}

static void hear_masks(struct observer *by, struct node *n, bool masked)
{
    struct node_races *r = checker(by);
    if (masked)
        return;
    r->main.released = true;
    if (r->handlers.runs)
        return;
    r->since = node_now(n);
    r->main.part =
        race_main_epoch(r); /* reads that synchronise begin none, and must be known from those before */
}

/* --- the rest --- */

static void hear_moves(struct observer *by, struct node *n, bool write, const void *at, size_t bytes)
{
    uint32_t place = *checker(by)->on ? race_place_in_call(n, n->call.name, __builtin_frame_address(0)) : 0;
    race_buffer_in_call(n, (uintptr_t)at, bytes, write, place);
    race_access_in_call(n, (uintptr_t)at, bytes, write, place);
}

static void hear_freed(struct observer *by, struct node *n, const void *at, size_t bytes)
{
    if (checker(by)->flights.count)
        race_buffer_in_call(n, (uintptr_t)at, bytes, true,
                            race_place_in_call(n, "free", __builtin_frame_address(0)));
}

static void hear_allocated(struct observer *by, struct node *n, const void *at, size_t bytes)
{
    (void)n;
    if (at && checker(by)->tracks)
        race_shadow_forget(checker(by)->shadow, (uintptr_t)at, bytes);
}

void races_loaded(struct node *n, struct node *host)
{
    struct node_races *r = races_of(n), *h = races_of(host);
    if (r && h)
        race_hear(r, h->number, now(h), h->handlers.runs ? h->handlers.heard : h->main.heard);
}

const struct announcements race_observer = {
    .in_order = true,
    .ends = hear_ends,
    .call_ends = hear_call_ends,
    .sends = hear_sends,
    .sent = hear_sent,
    .posts = hear_posts,
    .withdraws = hear_withdraws,
    .takes = hear_takes,
    .handler_begins = hear_handler_begins,
    .handler_ends = hear_handler_ends,
    .masks = hear_masks,
    .moves = hear_moves,
    .allocated = hear_allocated,
    .freed = hear_freed,
};
