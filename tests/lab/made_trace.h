/* made_trace.h - traces made by hand, for tests of what reads traces: trace_model.h. Calls are added node by node,
 * in order of time; a call's waits behind it. */
#ifndef TESTS_MADE_TRACE_H
#define TESTS_MADE_TRACE_H
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "lab/trace/trace_model.h"

enum { MADE_MOST = 1000 };

static inline void *made_room(size_t bytes)
{
    return xcalloc(MADE_MOST, bytes);
}

/* A trace of a hypercube, of so many nodes, with no calls yet, that ends at `end`. */
static inline struct trace made_trace(uint32_t nodes, vtime end)
{
    struct trace t = {.path = "made",
                      .program = "prog",
                      .machine = "ipsc860",
                      .command = "touchstone run prog",
                      .to = end,
                      .end = end,
                      .complete = true,
                      .node_count = (int32_t)nodes};
    topo_hypercube(&t.topo, nodes, 7);
    t.names = made_room(sizeof *t.names), t.classes = made_room(sizeof *t.classes);
    t.nodes = made_room(sizeof *t.nodes), t.calls = made_room(sizeof *t.calls),
    t.waits = made_room(sizeof *t.waits);
    t.handlers = made_room(sizeof *t.handlers), t.systems = made_room(sizeof *t.systems);
    t.messages = made_room(sizeof *t.messages), t.blocks = made_room(sizeof *t.blocks);
    for (uint32_t i = 0; i < nodes; i++) {
        t.nodes[i] = (struct trace_node){.address = i, .end = end, .traced = true};
        snprintf(t.nodes[i].name, sizeof t.nodes[i].name, "node %u", i);
    }
    return t;
}

static inline int32_t made_name(struct trace *t, const char *name, enum trace_class class)
{
    for (int32_t i = 0; i < t->name_count; i++)
        if (!strcmp(t->names[i], name))
            return i;
    t->names[t->name_count] = xstrdup(name), t->classes[t->name_count] = class;
    return t->name_count++;
}

static inline int32_t made_call(struct trace *t, int32_t node, const char *name, enum trace_class class,
                                int32_t type, vtime begin, vtime end)
{
    struct trace_node *n = &t->nodes[node];
    if (!n->calls++)
        n->first_call = t->call_count;
    t->calls[t->call_count] = (struct trace_call){.begin = begin,
                                                  .end = end,
                                                  .ordered = begin,
                                                  .node = node,
                                                  .name = made_name(t, name, class),
                                                  .stack = TRACE_NONE,
                                                  .type = type,
                                                  .has_type = true,
                                                  .sent = TRACE_NONE,
                                                  .taken = TRACE_NONE,
                                                  .first_wait = t->wait_count};
    return t->call_count++;
}

/* The last call added waited, all of it idle, for a message of its type. */
static inline int32_t made_wait(struct trace *t, vtime begin, vtime end)
{
    struct trace_call *c = &t->calls[t->call_count - 1];
    struct trace_node *n = &t->nodes[c->node];
    if (!n->waits++)
        n->first_wait = t->wait_count;
    c->waits++;
    t->waits[t->wait_count] = (struct trace_wait){.begin = begin,
                                                  .end = end,
                                                  .idle = end - begin,
                                                  .node = c->node,
                                                  .call = t->call_count - 1,
                                                  .type = c->type,
                                                  .has_type = true,
                                                  .from = TRACE_NONE,
                                                  .sends = t->classes[c->name] == TRACE_SENDS};
    return t->wait_count++;
}

/* A short message that call `sending` sent and call `taking` (or TRACE_NONE) took: it enters the network when
 * sent, moves from `moved` on, has left at `left`, is complete at `complete`. */
static inline int32_t made_message(struct trace *t, int32_t sending, int32_t taking, int32_t to,
                                   uint64_t bytes, vtime sent, vtime moved, vtime left, vtime complete)
{
    struct trace_call *s = &t->calls[sending], *r = taking == TRACE_NONE ? NULL : &t->calls[taking];
    int32_t from = s->node;
    s->sent = t->message_count;
    if (r)
        r->taken = t->message_count;
    t->messages[t->message_count] = (struct trace_message){.from = from,
                                                           .to = to,
                                                           .from_address = (uint32_t)from,
                                                           .to_address = (uint32_t)to,
                                                           .type = s->type,
                                                           .bytes = bytes,
                                                           .sent = sent,
                                                           .asked = VT_NEVER,
                                                           .granted = VT_NEVER,
                                                           .entered = sent,
                                                           .moved = moved,
                                                           .freed = VT_NEVER,
                                                           .left = left,
                                                           .complete = complete,
                                                           .taken = r ? r->end : VT_NEVER,
                                                           .sending = sending,
                                                           .taking = taking,
                                                           .first_block = t->block_count};
    return t->message_count++;
}

/* The last message added waited for a channel. */
static inline void made_block(struct trace *t, uint32_t channel, vtime begin, vtime end)
{
    t->messages[t->message_count - 1].blocks++;
    t->blocks[t->block_count++] =
        (struct trace_block){.begin = begin, .end = end, .message = t->message_count - 1, .channel = channel};
}
#endif
