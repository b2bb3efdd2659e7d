/* state_times.c - see state_times.h. */
#include "lab/draw/state_times.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

static const char *const NAMES[ACTIVITIES + 1] = {"computing",     "handler computing", "system (message)",
                                                  "system (call)", "waiting",           "ended"};

const char *activity_name(const struct trace *t, enum activity a)
{
    return a == ACTIVITIES && t->topo.host ? "no program" : NAMES[a];
}

enum activity activity_of(const struct trace_piece *p)
{
    switch (p->state) {
    case TRACE_COMPUTING:
        return p->in_handler ? ACTIVITY_HANDLER : ACTIVITY_COMPUTING;
    case TRACE_IN_CALL:
        return ACTIVITY_CALL;
    case TRACE_WAITING:
        return ACTIVITY_WAITING;
    case TRACE_IN_SYSTEM:
        return ACTIVITY_SYSTEM;
    default:
        return ACTIVITIES;
    }
}

static struct state_times room_for(int32_t rows, struct time_bins bins)
{
    struct state_times s = {.rows = rows, .bins = bins};
    s.sums = xcalloc((size_t)rows * bins.count * ACTIVITIES, sizeof *s.sums);
    return s;
}

struct state_times state_times_make(const struct trace *t, const struct node_rows *r, struct time_bins bins)
{
    struct state_times s = room_for(r->count, bins);
    struct trace_pieces pieces = {0};
    for (int32_t n = 0; n < t->node_count; n++) {
        if (r->row[n] == TRACE_NONE)
            continue;
        pieces.count = 0;
        trace_pieces(t, n, &pieces);
        for (const struct trace_piece *p = pieces.list; p < pieces.list + pieces.count; p++)
            if (activity_of(p) != ACTIVITIES)
                time_bins_add(&bins, state_times_at(&s, r->row[n], 0) + activity_of(p), ACTIVITIES, p->begin,
                              p->end, 1);
    }
    free(pieces.list);
    return s;
}

void state_times_free(struct state_times *s)
{
    free(s->sums);
}

struct state_times state_times_total(const struct state_times *s)
{
    struct state_times total = room_for(1, s->bins);
    size_t row = (size_t)s->bins.count * ACTIVITIES;
    for (size_t i = 0; i < row * (size_t)s->rows; i++)
        total.sums[i % row] += s->sums[i];
    return total;
}
