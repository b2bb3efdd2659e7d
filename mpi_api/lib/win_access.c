/* win_access.c - an access to another rank's memory: as messages, and what the target does with them.
 *
 *   struct win_head | struct win_span [spans] | data, in the order of the spans
 */
#include <stdlib.h>
#include <string.h>
#include "tasks.h"
#include "wins.h"

/* --- where --- */

/* The target's memory, from its window's base on. */
struct layout {
    int spans;
    struct win_span *span;
    size_t bytes;
};

static void add_span(struct layout *l, MPI_Aint at, size_t bytes)
{
    struct win_span *last = l->spans ? &l->span[l->spans - 1] : NULL;
    l->bytes += bytes;
    if (last && last->at + (MPI_Aint)last->bytes == at)
        last->bytes += bytes;
    else
        l->span[l->spans++] = (struct win_span){at, bytes};
}

/* A pair with a hole is two runs of its type, which begin with its value. */
static int runs_of_element(const struct access *a)
{
    return a->whole ? 2 : 1;
}

static struct layout layout_of(const struct win *w, const struct access *a)
{
    const struct type *t = type_of(a->their_type);
    MPI_Aint at = a->place * w->remote[a->rank].unit;
    bool one = t->runs == 1 && type_extent(t) == (MPI_Aint)t->size;
    struct layout l = {0};
    l.span = get_memory((one ? 1 : (size_t)a->their_count * (size_t)t->runs) * sizeof *l.span);
    if (one)
        add_span(&l, at + t->run[0].at, (size_t)(a->their_count * type_extent(t)));
    for (int i = 0; i < a->their_count && !one; i++, at += type_extent(t))
        for (int k = 0; k < t->runs; k += runs_of_element(a))
            add_span(&l, at + t->run[k].at, a->whole ? (size_t)extent_of(a->element) : t->run[k].bytes);
    return l;
}

/* --- what --- */

/* Copies pairs with their holes, to where they lie together, or from there. */
static void copy_whole(MPI_Datatype element, void *buf, int count, MPI_Datatype type, char *together,
                       bool out)
{
    const struct type *t = type_of(type);
    size_t bytes = (size_t)extent_of(element);
    char *at = buf;
    for (int i = 0; i < count; i++, at += type_extent(t))
        for (int k = 0; k < t->runs; k += 2, together += bytes)
            memcpy(out ? together : at + t->run[k].at, out ? at + t->run[k].at : together, bytes);
}

/* The data of so many bytes, together; *packed: in memory of its own, to be freed. */
static const char *data_of(const struct access *a, size_t all, char **packed)
{
    size_t bytes;
    *packed = NULL;
    if (!a->sends)
        return NULL;
    if (a->whole) {
        *packed = get_memory(all);
        copy_whole(a->element, (void *)(uintptr_t)a->buf, a->count, a->type, *packed, true);
        return *packed;
    }
    if (a->compare) {
        bytes = size_of(a->type);
        *packed = get_memory(2 * bytes);
        memcpy(*packed, a->buf, bytes);
        memcpy(*packed + bytes, a->compare, bytes);
        return *packed;
    }
    const char *at = type_together(a->buf, a->count, a->type, &bytes);
    if (at)
        return at;
    *packed = get_memory(bytes);
    type_pack(a->buf, a->count, a->type, *packed);
    return *packed;
}

static void add_pending(struct win *w, const struct pending *p)
{
    struct pending *own = get_memory(sizeof *own);
    *own = *p, own->next = NULL;
    *w->last_pending = own;
    w->last_pending = &own->next;
}

int win_node(const struct win *w, int rank)
{
    return group_node(w->comm->local, rank);
}

static struct nxm_envelope envelope(const struct win *w, int call, int tag, int node)
{
    return (struct nxm_envelope){call, tag, node, w->comm->context};
}

/* How much of the layout goes into a message: from here on. */
struct part {
    int span;
    size_t skip; /* of the span */
};

/* Takes spans, as many as fit, with `data` bytes for each of theirs; returns how many those are. */
static size_t take_spans(const struct layout *l, struct part *p, struct win_span *out, int *spans,
                         size_t room, size_t data, size_t element)
{
    size_t bytes = 0;
    for (*spans = 0; p->span < l->spans; ++*spans) {
        size_t used = (size_t)(*spans + 1) * sizeof *out + data * bytes;
        size_t some = l->span[p->span].bytes - p->skip;
        if (used <= room && data * some > room - used)
            some = (room - used) / data / element * element;
        if (used > room || !some)
            break;
        out[*spans] = (struct win_span){l->span[p->span].at + (MPI_Aint)p->skip, some};
        bytes += some, p->skip += some;
        if (p->skip == l->span[p->span].bytes)
            p->span++, p->skip = 0;
    }
    return bytes;
}

static struct win_head head_of(const struct access *a)
{
    return (struct win_head){.what = a->compare ? COMPARE : MOVE,
                             .op = (int)(intptr_t)a->op,
                             .element = (int)(intptr_t)(a->element ? a->element : MPI_BYTE),
                             .sends = a->sends,
                             .fetches = a->fetches,
                             .call = a->call};
}

/* --- sending --- */

/* The answer, what is fetched, will be put `into`. Answers of a target come in the order in which it was
 * asked. */
static void await_answer(struct win *w, const struct access *a, char *into, size_t bytes)
{
    const struct nxm_envelope e = envelope(w, a->call, FETCHED, win_node(w, a->rank));
    add_pending(w, &(struct pending){.id = (int)nxm_irecv(&e, into, (long)bytes), .rank = a->rank});
}

static void send_message(struct win *w, const struct nxm_envelope *e, int rank, void *message, size_t bytes)
{
    int id = (int)nxm_isend(e, message, (long)bytes, false);
    if (id)
        add_pending(w, &(struct pending){.id = id, .rank = rank, .memory = message});
    else
        free(message);
}

int access_messages(const struct access *a)
{
    return a->their_count > 0 && size_of(a->their_type) > 0;
}

/* What was fetched is unpacked when the last answer has come: it is the last that is pending. */
static void unpack_later(struct win *w, const struct access *a, char *packed)
{
    type_keep(a->as);
    add_pending(w, &(struct pending){.rank = a->rank,
                                     .memory = packed,
                                     .into = a->into,
                                     .room = a->room,
                                     .as = a->as,
                                     .whole = a->whole ? a->element : MPI_DATATYPE_NULL});
}

void access_send(struct win *w, const struct access *a, int tag, size_t most)
{
    if (!access_messages(a))
        return;
    struct layout l = layout_of(w, a);
    struct part p = {0};
    size_t done = 0, whole, element = a->element ? (size_t)extent_of(a->element) : 1;
    size_t data_bytes = a->sends ? 1 + (a->compare != NULL) : 0; /* of one of the target's */
    size_t all = (size_t)l.spans * sizeof(struct win_span) + data_bytes * l.bytes,
           room = all < most ? all : most;
    char *packed, *fetched = NULL, *into = NULL;
    const char *data = data_of(a, l.bytes, &packed);
    const struct nxm_envelope e = envelope(w, a->call, tag, win_node(w, a->rank));
    if (a->fetches && (a->whole || !(into = type_together(a->into, a->room, a->as, &whole))))
        into = fetched = get_memory(l.bytes);
    while (done < l.bytes) {
        char *message = get_memory(sizeof(struct win_head) + room);
        struct win_head head = head_of(a);
        struct win_span *span = (struct win_span *)(message + sizeof head);
        size_t bytes = take_spans(&l, &p, span, &head.spans, room, data_bytes, element);
        size_t sent = data_bytes * bytes;
        if (a->fetches)
            await_answer(w, a, into + done, bytes);
        memcpy(message, &head, sizeof head);
        if (sent)
            memcpy(span + head.spans, data + done, sent);
        send_message(w, &e, a->rank, message, sizeof head + (size_t)head.spans * sizeof *span + sent);
        done += bytes;
    }
    if (fetched)
        unpack_later(w, a, fetched);
    free(packed);
    free(l.span);
}

static void finish(int call, struct pending *p)
{
    struct nxm_status status;
    if (p->id)
        tasks_complete(&(struct nxm_completion){call, NXM_WAIT, 1, &p->id, &status});
    if (p->into && p->whole != MPI_DATATYPE_NULL)
        copy_whole(p->whole, p->into, p->room, p->as, p->memory, false);
    else if (p->into)
        type_unpack(p->memory, (size_t)p->room * size_of(p->as), p->into, p->room, p->as);
    if (p->into)
        type_leave(p->as);
    free(p->memory);
    free(p);
}

void access_wait(struct win *w, int call, int rank)
{
    struct pending *p = w->pending, *next;
    w->pending = NULL, w->last_pending = &w->pending;
    for (; p; p = next) {
        next = p->next;
        if (rank < 0 || p->rank == rank) {
            finish(call, p);
        } else {
            *w->last_pending = p;
            w->last_pending = &p->next;
            p->next = NULL;
        }
    }
}

void win_tell(struct win *w, int node, int tag, struct win_head head)
{
    const struct nxm_envelope e = envelope(w, head.call, tag, node);
    nxm_send(&e, &head, sizeof head, false);
}

void win_tell_pending(struct win *w, int node, int tag, struct win_head head)
{
    const struct nxm_envelope e = envelope(w, head.call, tag, node);
    struct win_head *message = get_memory(sizeof *message);
    *message = head;
    send_message(w, &e, -1, message, sizeof *message);
}

/* --- at the target --- */

static void answer(const struct win *w, const struct win_head *head, const struct win_span *span, int node)
{
    const struct nxm_envelope e = envelope(w, head->call, FETCHED, node);
    size_t bytes = 0;
    for (int i = 0; i < head->spans; i++)
        bytes += span[i].bytes;
    char *data = head->spans == 1 ? NULL : get_memory(bytes), *to = data;
    for (int i = 0; data && i < head->spans; to += span[i++].bytes)
        memcpy(to, w->base + span[i].at, span[i].bytes);
    nxm_send(&e, data ? data : w->base + span[0].at, (long)bytes, false);
    free(data);
}

static void change(const struct win *w, const struct win_head *head, const struct win_span *span, char *data)
{
    MPI_Op op = (MPI_Op)(intptr_t)head->op;
    MPI_Datatype element = (MPI_Datatype)(intptr_t)head->element;
    for (int i = 0; i < head->spans; data += span[i++].bytes) {
        char *at = w->base + span[i].at;
        if (op == MPI_REPLACE)
            memcpy(at, data, span[i].bytes);
        else
            op_apply(op, data, at, (int)(span[i].bytes / (size_t)extent_of(element)), element);
    }
}

void access_carry_out(struct win *w, char *message, int node)
{
    const struct win_head *head = (const struct win_head *)message;
    const struct win_span *span = (const struct win_span *)(message + sizeof *head);
    char *data = (char *)(uintptr_t)(span + head->spans);
    if (head->fetches)
        answer(w, head, span, node);
    if (head->what == COMPARE && memcmp(w->base + span->at, data + span->bytes, span->bytes) != 0)
        return;
    if (head->sends)
        change(w, head, span, data);
}
