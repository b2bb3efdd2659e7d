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
    pack_kind(r->packer, RECORD_END);
    pack(r->packer, end);
    for (int i = 0; i < 8; i++)
        pack_kind(r->packer, (uint8_t)(digest >> 8 * i));
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
        pack_kind(r->packer, (uint8_t)kind);
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
    pack_kind(r->packer, RECORD_STACK);
    pack(r->packer, program);
    pack(r->packer, depth);
    for (uint32_t i = 0; i < depth; i++)
        pack_signed(r->packer, (int64_t)(offsets[i] - (i ? offsets[i - 1] : 0)));
    return number;
}

/* --- records --- */

/* A time of an address, as the difference from its last one. */
static void pack_time(struct packer *p, vtime *last, vtime t)
{
    pack_signed(p, (int64_t)(t - *last));
    *last = t;
}

static void pack_wait(struct packer *p, const struct recorded_wait *w, vtime since)
{
    pack(p, w->begin - since);
    pack(p, w->end - w->begin);
    pack(p, w->busy);
    pack_kind(p, w->flags);
    if (w->flags & WAIT_HAS_TYPE)
        pack_signed(p, w->type);
    if (w->flags & WAIT_HAS_FROM)
        pack(p, w->from);
}

void recorder_call(struct recorder *r, const struct recorded_call *c)
{
    struct packer *p = r->packer;
    if (!overlaps(r, c->begin, c->end))
        return;
    pack_kind(p, RECORD_CALL);
    pack(p, c->address);
    pack_kind(p, c->flags);
    pack(p, c->name);
    pack(p, c->stack);
    if (c->flags & CALL_HAS_TYPE)
        pack_signed(p, c->type);
    pack_time(p, &r->last[c->address], c->begin);
    pack(p, c->end - c->begin);
    pack(p, c->ordered - c->begin);
    if (c->flags & CALL_SENT)
        pack(p, c->sent_order), pack(p, c->sent_count);
    if (c->flags & CALL_TOOK)
        pack(p, c->taken_source), pack(p, c->taken_order), pack(p, c->end - c->taken_at);
    pack(p, c->wait_count);
    for (uint32_t i = 0; i < c->wait_count; i++)
        pack_wait(p, &c->waits[i], i ? c->waits[i - 1].end : c->begin);
    r->last[c->address] = c->end;
}

void recorder_handler(struct recorder *r, const struct recorded_handler *h)
{
    struct packer *p = r->packer;
    if (!overlaps(r, h->begin, h->end))
        return;
    pack_kind(p, RECORD_HANDLER);
    pack(p, h->address);
    pack_kind(p, h->flags);
    pack_signed(p, h->type);
    pack(p, h->stack);
    pack_time(p, &r->last[h->address], h->begin);
    pack(p, h->begin - h->due);
    pack(p, h->entered - h->begin);
    pack(p, h->left - h->entered);
    pack(p, h->end - h->left);
    if (h->flags & HANDLER_HAS_MESSAGE)
        pack(p, h->source), pack(p, h->order);
    r->last[h->address] = h->end;
}

void recorder_system(struct recorder *r, uint32_t address, uint32_t task, vtime charged, vtime begin,
                     vtime end)
{
    if (!recorder_wants(r, address) || !overlaps(r, begin, end))
        return;
    pack_kind(r->packer, RECORD_SYSTEM);
    pack(r->packer, address);
    pack(r->packer, task);
    pack_time(r->packer, &r->last_system[address], charged);
    pack(r->packer, begin - charged);
    pack(r->packer, end - begin);
    r->last_system[address] = end;
}

static void pack_blocks(struct packer *p, const struct recorded_message *m)
{
    vtime last = m->times[MESSAGE_ENTERED];
    pack(p, m->block_count);
    for (const struct recorded_block *b = m->blocks; b < m->blocks + m->block_count; b++) {
        pack(p, b->channel);
        pack(p, b->begin - last);
        pack(p, b->end == VT_NEVER ? 0 : b->end - b->begin + 1);
        last = b->end;
    }
}

void recorder_message(struct recorder *r, const struct recorded_message *m)
{
    struct packer *p = r->packer;
    uint64_t flags = (m->is_long ? MESSAGE_LONG : 0) | (m->pid ? MESSAGE_HAS_PID : 0);
    if (!overlaps(r, m->sent, m->times[MESSAGE_COMPLETE]) ||
        (!recorder_wants(r, m->from) && !recorder_wants(r, m->to)))
        return;
    for (int i = 0; i < MESSAGE_TIMES; i++)
        if (m->times[i] != VT_NEVER)
            flags |= (uint64_t)MESSAGE_FIRST_TIME << i;
    pack_kind(p, RECORD_MESSAGE);
    pack(p, m->source);
    pack(p, m->order);
    pack(p, m->from);
    pack(p, m->to);
    pack(p, flags);
    pack_signed(p, m->type);
    pack(p, m->bytes);
    if (m->pid)
        pack_signed(p, m->pid);
    pack_time(p, &r->last_sent, m->sent);
    vtime last = m->sent;
    for (int i = 0; i < MESSAGE_TIMES; i++)
        if (m->times[i] != VT_NEVER)
            pack_signed(p, (int64_t)(m->times[i] - last)), last = m->times[i];
    pack_blocks(p, m);
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
    pack_kind(r->packer, RECORD_NODE_END);
    pack(r->packer, address);
    pack(r->packer, t);
}
