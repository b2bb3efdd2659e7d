/* message_sample.c - see message_sample.h. */
#include "lab/show/message_sample.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

static bool is_shown(const struct trace *t, const struct node_rows *r, const struct trace_message *m)
{
    return m->from != TRACE_NONE && m->to != TRACE_NONE && r->row[m->from] != TRACE_NONE &&
           r->row[m->to] != TRACE_NONE && m->sent <= t->to && m->complete != VT_NEVER &&
           m->complete >= t->from;
}

/* Steele, Lea & Flood, Fast Splittable Pseudorandom Number Generators, OOPSLA 2014: the finaliser. */
static uint64_t hash(uint64_t x)
{
    x += UINT64_C(0x9e3779b97f4a7c15);
    x = (x ^ (x >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ (x >> 27)) * UINT64_C(0x94d049bb133111eb);
    return x ^ (x >> 31);
}

struct message_sample message_sample_make(const struct trace *t, const struct node_rows *r, size_t most)
{
    struct message_sample s = {.list = xcalloc((size_t)t->message_count, sizeof *s.list)};
    for (int32_t i = 0; i < t->message_count; i++)
        if (is_shown(t, r, &t->messages[i]))
            s.list[s.of++] = i;
    s.count = s.of < most ? s.of : most;
    for (size_t i = 0; s.count < s.of && i < s.count; i++) {
        size_t first = i * s.of / s.count, next = (i + 1) * s.of / s.count;
        s.list[i] = s.list[first + hash(i) % (next - first)]; /* never before s.list[i] */
    }
    return s;
}

void message_sample_free(struct message_sample *s)
{
    free(s->list);
}
