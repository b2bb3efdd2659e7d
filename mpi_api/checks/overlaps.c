/* overlaps.c - see overlaps.h. */
#include "mpi_api/checks/overlaps.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "mpi_api/core/told_accesses.h"
#include "node/node.h"
#include "nx_api/contract/backend.h"

/* What a call sends from, or receives in: stretches of memory, and the one that has all of them. */
struct stretches {
    struct told_access *list;
    size_t count, room;
    uintptr_t begin, end;
};

/* [0] of what is sent, [1] of what is received. */
static void note(void *ctx, const struct told_access *a)
{
    struct stretches *s = (struct stretches *)ctx + a->write;
    if (s->count == s->room)
        s->list = xreallocarray(s->list, s->room = s->room ? 2 * s->room : 16, sizeof *s->list);
    s->begin = s->count && s->begin < a->at ? s->begin : a->at;
    s->end = s->end > a->at + a->bytes ? s->end : a->at + a->bytes;
    s->list[s->count++] = *a;
}

static bool is_before(const struct told_access *a, const struct told_access *b)
{
    return a->at + a->bytes <= b->at;
}

static bool overlap(const struct stretches *sent, const struct stretches *received)
{
    bool near = sent->begin < received->end && received->begin < sent->end, found = false;
    for (size_t i = 0; near && i < sent->count && !found; i++)
        for (size_t k = 0; k < received->count && !found; k++)
            found = !is_before(&sent->list[i], &received->list[k]) &&
                    !is_before(&received->list[k], &sent->list[i]);
    return found;
}

void overlaps_begin(struct mpi_findings *all, struct node *n, const struct nxm_told *c,
                    const struct nxm_library *l)
{
    struct stretches s[2] = {{0}};
    const char *stem = told_stem(c);
    if (strcmp(stem, "Sendrecv_replace") == 0)
        return;
    told_accesses(l, c, note, s);
    if (overlap(&s[0], &s[1])) {
        const struct mpi_place place = mpi_place(n, c);
        bool pair = strcmp(stem, "Sendrecv") == 0;
        node_order(n); /* the findings are of all nodes */
        mpi_findings_add(all, ONE_MEMORY, n->id, &place, NULL,
                         pair ? "MPI has MPI_Sendrecv_replace for that" : "MPI has MPI_IN_PLACE for that");
    }
    free(s[0].list);
    free(s[1].list);
}
