/* mpi_findings.c - see mpi_findings.h. */
#include "mpi_api/checks/mpi_findings.h"
#include <stdlib.h>
#include <string.h>
#include "guest/image.h"
#include "kernel/xalloc.h"
#include "node/node.h"
#include "node/self.h"

struct finding {
    enum mpi_finding kind;
    struct mpi_place place, other;
    char *detail;
    uint64_t count;
    uint32_t nodes, first, last; /* so many nodes, between these */
    uint8_t *on;                 /* a bit for each, up to the last */
};

struct mpi_findings {
    struct finding *list;
    size_t count, room;
};

struct mpi_findings *mpi_findings_new(void)
{
    return xcalloc(1, sizeof(struct mpi_findings));
}

void mpi_findings_free(struct mpi_findings *all)
{
    for (size_t i = 0; i < all->count; i++)
        free(all->list[i].detail), free(all->list[i].on);
    free(all->list);
    free(all);
}

/* --- places --- */

struct mpi_place mpi_place(const struct node *n, const struct nxm_told *c)
{
    struct mpi_place p = {.call = told_name(c), .file = n->guest.file};
    const void *const *frame = c->frame;
    uintptr_t returns = (uintptr_t)c->returns;
    for (int i = 0; i < MPI_FRAMES && returns - (uintptr_t)n->guest.program < n->guest.image_bytes; i++) {
        p.at[i] = (uint32_t)(returns - (uintptr_t)n->guest.program);
        if (!node_may_be_frame(n, (uintptr_t)frame))
            break;
        returns = (uintptr_t)frame[1];
        frame = frame[0];
    }
    return p;
}

static bool same_place(const struct mpi_place *a, const struct mpi_place *b)
{
    return a->call == b->call && a->file == b->file && memcmp(a->at, b->at, sizeof a->at) == 0;
}

/* "MPI_Irecv at leaks.c:12", malloc'd. */
static char *place_text(const struct mpi_place *p)
{
    char line[200];
    bool known = false;
    for (int i = 0; i < MPI_FRAMES && p->at[i] && !known; i++)
        known = node_image_line_outside(p->file, p->at[i] - 1, line, sizeof line);
    for (int i = 0; i < MPI_FRAMES && p->at[i] && !known; i++)
        known = node_image_line(p->file, p->at[i] - 1, line, sizeof line);
    const char *function = known || !p->at[0] ? NULL : node_image_function_name(p->file, p->at[0] - 1);
    return xasprintf("%s%s%s", p->call,
                     known      ? " at "
                     : function ? " in "
                                : "",
                     known      ? line
                     : function ? function
                                : "");
}

/* One place, or two: places that differ by their callers have one text. Malloc'd. */
static char *places_text(const struct mpi_place *a, const struct mpi_place *b)
{
    char *first = place_text(a), *second = b->call ? place_text(b) : NULL;
    if (!second || strcmp(first, second) == 0) {
        free(second);
        return first;
    }
    char *both = xasprintf("%s and %s", first, second);
    free(first);
    free(second);
    return both;
}

/* --- findings --- */

static void note_node(struct finding *d, uint32_t node)
{
    if (!d->on || node > d->last) {
        size_t had = d->on ? d->last / 8 + 1 : 0, has = node / 8 + 1;
        d->on = xreallocarray(d->on, has, 1);
        memset(d->on + had, 0, has - had);
        d->last = node;
    }
    d->first = d->nodes && d->first < node ? d->first : node;
    d->nodes += !(d->on[node / 8] >> node % 8 & 1);
    d->on[node / 8] |= (uint8_t)(1 << node % 8);
}

void mpi_findings_add(struct mpi_findings *all, enum mpi_finding kind, uint32_t node,
                      const struct mpi_place *place, const struct mpi_place *other, const char *detail)
{
    static const struct mpi_place none;
    other = other ? other : &none;
    struct finding *d = NULL;
    for (size_t i = 0; i < all->count && !d; i++)
        if (all->list[i].kind == kind && same_place(&all->list[i].place, place) &&
            same_place(&all->list[i].other, other))
            d = &all->list[i];
    if (!d) {
        if (all->count == all->room)
            all->list = xreallocarray(all->list, all->room = all->room ? 2 * all->room : 16, sizeof *d);
        d = &all->list[all->count++];
        *d = (struct finding){.kind = kind, .place = *place, .other = *other, .detail = xstrdup(detail)};
    }
    d->count++;
    note_node(d, node);
}

static const char *const texts[MPI_FINDINGS] = {
    [PENDING_REQUESTS] = "request never completed",
    [KEPT_REQUESTS] = "persistent request not freed",
    [UNRECEIVED] = "message never received",
    [TOO_LONG] = "message longer than its receive",
    [KEPT_COMMS] = "communicator not freed",
    [KEPT_TYPES] = "datatype not freed",
    [KEPT_GROUPS] = "group not freed",
    [KEPT_OPS] = "operation not freed",
    [OTHER_CALLS] = "collectives differ",
    [OTHER_ROOTS] = "roots differ",
    [OTHER_OPS] = "operations differ",
    [OTHER_AMOUNTS] = "counts or datatypes differ",
    [OTHER_TYPES] = "datatypes differ",
    [ONE_MEMORY] = "a call sends and receives in the same memory",
    [NOT_FINALIZED] = "MPI_Finalize never called",
};

static void print_finding(const struct finding *d, const char *places, const char *before, FILE *f)
{
    fprintf(f, "%sMPI: %s: %s", before, texts[d->kind], places);
    if (*d->detail)
        fprintf(f, ": %s", d->detail);
    if (d->count > 1)
        fprintf(f, "%s %llu times", *d->detail ? ";" : ",", (unsigned long long)d->count);
    if (d->nodes == 1 && (d->count > 1 || !*d->detail))
        fprintf(f, ", on node %u", d->first);
    else if (d->nodes > 1)
        fprintf(f, d->last - d->first + 1 == d->nodes ? ", on nodes %u-%u" : ", on nodes of %u-%u", d->first,
                d->last);
    fputc('\n', f);
}

/* Adds to a finding what was found at a place of the same text. */
static void join(struct finding *to, struct finding *d)
{
    to->count += d->count;
    d->count = 0;
    for (uint32_t node = d->first; node <= d->last; node++)
        if (d->on[node / 8] >> node % 8 & 1)
            note_node(to, node);
}

bool mpi_findings_print(struct mpi_findings *all, const char *before, FILE *f)
{
    char **places = xcalloc(all->count + 1, sizeof *places);
    for (size_t i = 0; i < all->count; i++) {
        places[i] = places_text(&all->list[i].place, &all->list[i].other);
        for (size_t k = 0; k < i && all->list[i].count; k++)
            if (all->list[k].count && all->list[k].kind == all->list[i].kind && !strcmp(places[k], places[i]))
                join(&all->list[k], &all->list[i]);
    }
    for (int kind = 0; kind < MPI_FINDINGS; kind++)
        for (size_t i = 0; i < all->count; i++)
            if (all->list[i].count && all->list[i].kind == (enum mpi_finding)kind)
                print_finding(&all->list[i], places[i], before, f);
    for (size_t i = 0; i < all->count; i++)
        free(places[i]);
    free(places);
    return all->count > 0;
}
