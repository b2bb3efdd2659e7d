/* trace_channels.c - the channels that messages held, and when; see trace_model.h. A message takes the
 * channels of its path in order, and takes no time for a free one; it gives all of them back when its tail
 * has passed. */
#include <stdio.h>
#include "lab/trace/trace_parts.h"

/* When the message held the i-th channel of its path: from when it had waited for the last channel up to
 * there. */
static void use_path(const struct trace *t, int32_t message, trace_use *use, void *ctx)
{
    const struct trace_message *m = &t->messages[message];
    const struct trace_block *block = &t->blocks[m->first_block], *last = block + m->blocks;
    vtime at = m->entered, end = vt_min(m->left, t->to);
    struct topo_walk walk;
    topo_begin(&t->topo, &walk, m->from_address, m->to_address);
    for (uint32_t channel; topo_step(&t->topo, &walk, &channel);) {
        if (block < last && block->channel == channel) {
            if (block->end == VT_NEVER)
                return; /* it still waits */
            at = (block++)->end;
        }
        vtime until =
            m->freed != VT_NEVER && topo_channel(&t->topo, channel).kind == TOPO_LINK ? m->freed : end;
        if (at < vt_min(until, end))
            use(ctx, channel, message, at, vt_min(until, end));
    }
}

void trace_channel_uses(const struct trace *t, trace_use *use, void *ctx)
{
    for (int32_t i = 0; i < t->message_count; i++)
        if (t->messages[i].entered != VT_NEVER)
            use_path(t, i, use, ctx);
}

/* Writes "node 3", "host", or "I/O 2" for the second service. */
static void write_end(const struct trace *t, uint32_t address, char *buf, size_t size)
{
    int32_t node = trace_node_at(t, address);
    if (node != TRACE_NONE)
        snprintf(buf, size, "%s", t->nodes[node].name);
    else if (address >= t->topo.positions)
        snprintf(buf, size, "I/O %u", address - t->topo.positions);
    else
        snprintf(buf, size, "idle node %u", address);
}

const char *trace_channel_name(const struct trace *t, uint32_t channel, char *buf, size_t size)
{
    struct topo_channel c = topo_channel(&t->topo, channel);
    char from[32], to[32];
    write_end(t, c.from, from, sizeof from);
    write_end(t, c.to, to, sizeof to);
    if (c.kind == TOPO_LINK)
        snprintf(buf, size, "%s -> %s", from, to);
    else
        snprintf(buf, size, "%s %s", from, c.kind == TOPO_IN ? "into the network" : "out of the network");
    return buf;
}
