/* why.c - see why.h: puts the parts together. */
#include "lab/why/why.h"
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lab/why/block_holders.h"
#include "lab/why/path_shares.h"
#include "lab/why/wait_groups.h"

struct why *why_new(struct trace *t, const struct trace_selection *only)
{
    struct why *w = xcalloc(1, sizeof *w);
    w->t = t;
    w->map = piece_map_new(t);
    w->enders = wait_enders_new(t);
    w->places = places_new(t);
    w->path = path_find(t, &w->map, &w->enders);
    w->length = t->to - t->from;
    w->causes = wait_causes_find(t, &w->map, &w->enders, only);
    w->some_nodes = only && only->nodes;
    w->holder = block_holders_find(t);
    path_shares_find(w);
    wait_groups_find(w);
    return w;
}

void why_free(struct why *w)
{
    if (!w)
        return;
    for (int i = 0; i < WHY_SHARES; i++)
        tally_free(&w->shares[i]);
    free(w->groups);
    free(w->holder);
    free(w->path.steps);
    free(w->causes.parts);
    piece_map_free(&w->map);
    wait_enders_free(&w->enders);
    places_free(w->places);
    trace_free(w->t);
    free(w);
}

const char *why_node_name(const struct why *w, int32_t node)
{
    return node == TRACE_NONE ? "network" : w->t->nodes[node].name;
}
