/* protocol_record.c - see protocol_record.h. In a run that is recorded, trips and messages have more room
 * behind them. */
#include "net/protocol_record.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "net/protocol_parts.h"

struct recorded_trip {
    struct trip trip;
    bool told; /* the recorder has been told of it */
    vtime sent, times[MESSAGE_TIMES];
    struct recorded_block *blocks;
    uint32_t block_count, block_room;
};

static struct recorded_trip *recorded(struct trip *t)
{
    return (struct recorded_trip *)t;
}

/* A message's order lies behind all of it. */
static uint64_t *order_of(const struct message *m)
{
    return (uint64_t *)((char *)m + protocol_pool_of(m)->bytes) - 1;
}

uint64_t protocol_recorded_order(const struct message *m)
{
    return *order_of(m);
}

uint64_t protocol_next_order(const struct protocol *p, uint32_t address)
{
    return p->endpoints[address].made;
}

/* --- what the protocol tells --- */

void protocol_note_begin(struct trip *t)
{
    struct recorded_trip *r = recorded(t);
    r->told = false;
    r->sent = VT_NEVER;
    for (int i = 0; i < MESSAGE_TIMES; i++)
        r->times[i] = VT_NEVER;
    r->blocks = NULL, r->block_count = r->block_room = 0;
}

void protocol_note_time(struct trip *t, int which, vtime when)
{
    struct recorded_trip *r = recorded(t);
    if (which == MESSAGE_TIMES)
        r->sent = when;
    else
        r->times[which] = when;
}

static void tell(const struct protocol *p, struct recorded_trip *r)
{
    const struct message *m = r->trip.m;
    if (r->told || r->sent == VT_NEVER || r->trip.taken_back)
        return;
    r->told = true;
    struct recorded_message told = {.source = r->trip.source,
                                    .order = r->trip.order,
                                    .from = m->from,
                                    .to = m->to,
                                    .type = m->type,
                                    .pid = m->pid,
                                    .bytes = m->bytes,
                                    .is_long = m->is_long,
                                    .sent = r->sent,
                                    .blocks = r->blocks,
                                    .block_count = r->block_count};
    memcpy(told.times, r->times, sizeof told.times);
    recorder_message(p->recorder, &told);
}

void protocol_note_end(struct protocol *p, struct trip *t)
{
    tell(p, recorded(t));
    *order_of(t->m) = t->order;
    free(recorded(t)->blocks);
}

/* --- what the channels tell --- */

static struct recorded_trip *recorded_of(struct channel_transit *t)
{
    return recorded((struct trip *)((char *)t - offsetof(struct trip, transit)));
}

static void blocked(void *ctx, struct channel_transit *t, uint32_t channel, vtime now)
{
    struct recorded_trip *r = recorded_of(t);
    (void)ctx;
    if (r->block_count == r->block_room) {
        r->block_room = r->block_room ? 2 * r->block_room : 2;
        r->blocks = xreallocarray(r->blocks, r->block_room, sizeof *r->blocks);
    }
    r->blocks[r->block_count++] = (struct recorded_block){channel, now, VT_NEVER};
}

static void unblocked(void *ctx, struct channel_transit *t, vtime now)
{
    struct recorded_trip *r = recorded_of(t);
    (void)ctx;
    r->blocks[r->block_count - 1].end = now;
}

/* --- begin and end --- */

void protocol_record(struct protocol *p, struct recorder *r)
{
    p->recorder = r;
    p->trips.bytes = sizeof(struct recorded_trip);
    for (unsigned i = 0; i < PROTOCOL_SIZES; i++)
        p->messages[i].bytes += sizeof(uint64_t);
    channel_tell_blocks(p->channels, &(struct channel_calls){.blocked = blocked, .unblocked = unblocked});
}

void protocol_record_end(struct protocol *p)
{
    for (uint32_t i = 0; i < p->topo.addresses; i++)
        for (struct trip *t = p->endpoints[i].in; t; t = t->next_in)
            tell(p, recorded(t));
}
