/* history.c - see history.h. */
#include "machine/history.h"
#include <inttypes.h>

static uint64_t mix(uint64_t h, uint64_t x)
{
    h = (h ^ x) * UINT64_C(0x9e3779b97f4a7c15);
    return h ^ (h >> 29);
}

/* Those between nodes and services have no types that programs know. */
static void count(struct node_system *sys, const struct message *m)
{
    sys->messages++;
    sys->bytes += m->bytes;
    sys->types_come[node_type_hash(m->type) / 64] |= UINT64_C(1) << node_type_hash(m->type) % 64;
}

void history_add(struct node_system *sys, const struct message *m, vtime now)
{
    sys->digest = mix(mix(sys->digest, now), (uint64_t)m->from << 32 | m->to);
    sys->digest = mix(mix(sys->digest, (uint64_t)m->type), m->bytes);
    if (!m->serves)
        count(sys, m);
    if (sys->history)
        fprintf(sys->history, "%" PRIu64 " %u %u %d %zu\n", now, m->from, m->to, m->type, m->bytes);
}
