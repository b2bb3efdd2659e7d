/* recorder.c - see recorder.h. */
#include "trace/recorder.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "trace/interned.h"
#include "trace/packer.h"

/* Names that have been asked for lately, by where their texts are. */
enum { LATELY = 64 };
struct lately {
    const char *name;
    uint32_t number;
};

struct recorder {
    struct recorder_options options;
    struct lately lately[LATELY];
    struct packer *packer;
    struct interned *names, *programs, *stacks;
    vtime *last, *last_system; /* by address */
    vtime last_sent;
};

struct recorder *recorder_new(const struct recorder_options *o, const json_t *head)
{
    struct recorder *r = xcalloc(1, sizeof *r);
    r->options = *o;
    r->packer = packer_new(o->out);
    r->names = interned_new(), r->programs = interned_new(), r->stacks = interned_new();
    r->last = xcalloc(o->addresses, sizeof *r->last);
    r->last_system = xcalloc(o->addresses, sizeof *r->last_system);
    fputs(TRACE_MAGIC, o->out);
    char *text = xchecked(json_dumps(head, JSON_COMPACT));
    pack_bytes(r->packer, text, strlen(text));
    free(text);
    return r;
}

void recorder_end(struct recorder *r, vtime end, uint64_t digest)
{
    pack(r->packer, RECORD_END);
    pack(r->packer, end);
    for (int i = 0; i < 8; i++)
        pack_byte(r->packer, (uint8_t)(digest >> 8 * i));
    packer_end(r->packer);
    interned_free(r->names);
    interned_free(r->programs);
    interned_free(r->stacks);
    free(r->last);
    free(r->last_system);
    free(r);
}

/* --- what is wanted --- */

bool recorder_wants(const struct recorder *r, uint32_t address)
{
    return !r->options.nodes || (address < r->options.node_count && r->options.nodes[address]);
}

static bool overlaps(const struct recorder *r, vtime begin, vtime end)
{
    return begin <= r->options.to && end >= r->options.from;
}

/* --- what is numbered --- */

/* Writes a text that is new. */
static uint32_t number_text(struct recorder *r, struct interned *all, enum record_kind kind, const char *text)
{
    bool is_new;
    uint32_t number = interned_number(all, text, strlen(text), &is_new);
    if (is_new) {
        pack(r->packer, kind);
        pack_bytes(r->packer, text, strlen(text));
    }
    return number;
}

uint32_t recorder_name(struct recorder *r, const char *name)
{
    struct lately *l = &r->lately[((uintptr_t)name >> 3) % LATELY];
    if (l->name != name)
        *l = (struct lately){name, number_text(r, r->names, RECORD_NAME, name)};
    return l->number;
}

uint32_t recorder_program(struct recorder *r, const char *path)
{
    return number_text(r, r->programs, RECORD_PROGRAM, path);
}

uint32_t recorder_stack(struct recorder *r, uint32_t program, const uintptr_t *offsets, uint32_t depth)
{
    enum { DEEPEST = 64 };
    uintptr_t key[DEEPEST + 1];
    bool is_new;
    assert(depth <= DEEPEST);
    key[0] = program;
    memcpy(key + 1, offsets, depth * sizeof *offsets);
    uint32_t number = interned_number(r->stacks, key, (depth + 1) * sizeof *key, &is_new);
    if (!is_new)
        return number;
    uint8_t *at = packer_room(r->packer, 3 + depth);
    put(&at, RECORD_STACK);
    put(&at, program);
    put(&at, depth);
    for (uint32_t i = 0; i < depth; i++)
        put_signed(&at, (int64_t)(offsets[i] - (i ? offsets[i - 1] : 0)));
    packer_wrote(r->packer, at);
    return number;
}

/* --- records --- */

/* Numbers of a record, without waits and blocks, or of one of these: fewer. */
enum { MOST_NUMBERS = 20 };

/* A time of an address, as the difference from its last one. */
static void put_time(uint8_t **at, vtime *last, vtime t)
{
    put_signed(at, (int64_t)(t - *last));
    *last = t;
}

static void pack_wait(struct packer *p, const struct recorded_wait *w, vtime since)
{
    uint8_t *at = packer_room(p, MOST_NUMBERS);
    put(&at, w->begin - since);
    put(&at, w->end - w->begin);
    put(&at, w->busy);
    put(&at, w->flags);
    if (w->flags & WAIT_HAS_TYPE)
        put_signed(&at, w->type);
    if (w->flags & WAIT_HAS_FROM)
        put(&at, w->from);
    packer_wrote(p, at);
}

void recorder_call(struct recorder *r, const struct recorded_call *c)
{
    if (!overlaps(r, c->begin, c->end))
        return;
    uint8_t *at = packer_room(r->packer, MOST_NUMBERS);
    put(&at, RECORD_CALL);
    put(&at, c->address);
    put(&at, c->flags);
    put(&at, c->name);
    put(&at, c->stack);
    if (c->flags & CALL_HAS_TYPE)
        put_signed(&at, c->type);
    put_time(&at, &r->last[c->address], c->begin);
    put(&at, c->end - c->begin);
    put(&at, c->ordered - c->begin);
    if (c->flags & CALL_SENT)
        put(&at, c->sent_order), put(&at, c->sent_count);
    if (c->flags & CALL_TOOK)
        put(&at, c->taken_source), put(&at, c->taken_order), put(&at, c->end - c->taken_at);
    put(&at, c->wait_count);
    packer_wrote(r->packer, at);
    for (uint32_t i = 0; i < c->wait_count; i++)
        pack_wait(r->packer, &c->waits[i], i ? c->waits[i - 1].end : c->begin);
    r->last[c->address] = c->end;
}

void recorder_handler(struct recorder *r, const struct recorded_handler *h)
{
    if (!overlaps(r, h->begin, h->end))
        return;
    uint8_t *at = packer_room(r->packer, MOST_NUMBERS);
    put(&at, RECORD_HANDLER);
    put(&at, h->address);
    put(&at, h->flags);
    put_signed(&at, h->type);
    put(&at, h->stack);
    put_time(&at, &r->last[h->address], h->begin);
    put(&at, h->begin - h->due);
    put(&at, h->entered - h->begin);
    put(&at, h->left - h->entered);
    put(&at, h->end - h->left);
    if (h->flags & HANDLER_HAS_MESSAGE)
        put(&at, h->source), put(&at, h->order);
    packer_wrote(r->packer, at);
    r->last[h->address] = h->end;
}

void recorder_system(struct recorder *r, uint32_t address, uint32_t task, vtime charged, vtime begin,
                     vtime end)
{
    if (!recorder_wants(r, address) || !overlaps(r, begin, end))
        return;
    uint8_t *at = packer_room(r->packer, MOST_NUMBERS);
    put(&at, RECORD_SYSTEM);
    put(&at, address);
    put(&at, task);
    put_time(&at, &r->last_system[address], charged);
    put(&at, begin - charged);
    put(&at, end - begin);
    packer_wrote(r->packer, at);
    r->last_system[address] = end;
}

static void pack_blocks(struct packer *p, const struct recorded_message *m)
{
    vtime last = m->times[MESSAGE_ENTERED];
    for (const struct recorded_block *b = m->blocks; b < m->blocks + m->block_count; b++) {
        uint8_t *at = packer_room(p, MOST_NUMBERS);
        put(&at, b->channel);
        put(&at, b->begin - last);
        put(&at, b->end == VT_NEVER ? 0 : b->end - b->begin + 1);
        packer_wrote(p, at);
        last = b->end;
    }
}

void recorder_message(struct recorder *r, const struct recorded_message *m)
{
    uint64_t flags = (m->is_long ? MESSAGE_LONG : 0) | (m->pid ? MESSAGE_HAS_PID : 0);
    if (!overlaps(r, m->sent, m->times[MESSAGE_COMPLETE]) ||
        (!recorder_wants(r, m->from) && !recorder_wants(r, m->to)))
        return;
    for (int i = 0; i < MESSAGE_TIMES; i++)
        if (m->times[i] != VT_NEVER)
            flags |= (uint64_t)MESSAGE_FIRST_TIME << i;
    uint8_t *at = packer_room(r->packer, MOST_NUMBERS);
    put(&at, RECORD_MESSAGE);
    put(&at, m->source);
    put(&at, m->order);
    put(&at, m->from);
    put(&at, m->to);
    put(&at, flags);
    put_signed(&at, m->type);
    put(&at, m->bytes);
    if (m->pid)
        put_signed(&at, m->pid);
    put_time(&at, &r->last_sent, m->sent);
    vtime last = m->sent;
    for (int i = 0; i < MESSAGE_TIMES; i++)
        if (m->times[i] != VT_NEVER)
            put_signed(&at, (int64_t)(m->times[i] - last)), last = m->times[i];
    put(&at, m->block_count);
    packer_wrote(r->packer, at);
    pack_blocks(r->packer, m);
}

void recorder_no_program(struct recorder *r, uint32_t address, vtime t)
{
    recorder_call(r, &(struct recorded_call){.address = address,
                                             .name = recorder_name(r, RECORDER_NO_PROGRAM),
                                             .begin = r->last[address],
                                             .ordered = t,
                                             .end = t});
}

void recorder_node_end(struct recorder *r, uint32_t address, vtime t)
{
    pack(r->packer, RECORD_NODE_END);
    pack(r->packer, address);
    pack(r->packer, t);
}
