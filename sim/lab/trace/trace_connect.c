/* trace_connect.c - sorts the tables of a trace that has been read, and connects them by indexes. */
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "lab/trace/trace_parts.h"

enum trace_class trace_class_of(const char *call)
{
    static const struct {
        const char *begins;
        enum trace_class class;
    } CLASSES[] = {{"csendrecv", TRACE_RECEIVES},
                   {"csend", TRACE_SENDS},
                   {"isend", TRACE_SENDS},
                   {"hsend", TRACE_SENDS},
                   {"crecv", TRACE_RECEIVES},
                   {"irecv", TRACE_RECEIVES},
                   {"hrecv", TRACE_RECEIVES},
                   {"isendrecv", TRACE_RECEIVES},
                   {"hsendrecv", TRACE_RECEIVES},
                   {"msgwait", TRACE_RECEIVES},
                   {"cprobe", TRACE_RECEIVES},
                   {"iprobe", TRACE_RECEIVES},
                   {"msgdone", TRACE_RECEIVES},
                   {"msgmerge", TRACE_RECEIVES},
                   {"cread", TRACE_FILES},
                   {"cwrite", TRACE_FILES},
                   {"iread", TRACE_FILES},
                   {"iwrite", TRACE_FILES},
                   {"iowait", TRACE_FILES},
                   {"iodone", TRACE_FILES},
                   {"gopen", TRACE_FILES},
                   {"setiomode", TRACE_FILES},
                   {"lseek", TRACE_FILES},
                   {"eseek", TRACE_FILES},
                   {"open", TRACE_FILES},
                   {"close", TRACE_FILES},
                   {"read", TRACE_FILES},
                   {"write", TRACE_FILES},
                   {"fsync", TRACE_FILES},
                   {"unlink", TRACE_FILES},
                   {"rename", TRACE_FILES},
                   {"mkdir", TRACE_FILES},
                   {"stat", TRACE_FILES},
                   {"iseof", TRACE_FILES},
                   {"lsize", TRACE_FILES},
                   {"esize", TRACE_FILES},
                   {"g", TRACE_GLOBAL}};
    if (*call == '_')
        call++;
    if (!strncmp(call, "get", 3) || !strncmp(call, "ginv", 4) || !strncmp(call, "gray", 4))
        return TRACE_OTHER;
    for (size_t i = 0; i < sizeof CLASSES / sizeof *CLASSES; i++)
        if (!strncmp(call, CLASSES[i].begins, strlen(CLASSES[i].begins)))
            return CLASSES[i].class;
    return TRACE_OTHER;
}

/* --- sorting --- */

/* The order of a table's entries: by node, then time, then `tie`, then as they came. */
struct key {
    int32_t node, index;
    vtime time;
    uint64_t tie;
};

static int by_key(const void *a, const void *b)
{
    const struct key *x = a, *y = b;
    if (x->node != y->node)
        return x->node < y->node ? -1 : 1;
    if (x->time != y->time)
        return x->time < y->time ? -1 : 1;
    if (x->tie != y->tie)
        return x->tie < y->tie ? -1 : 1;
    return x->index < y->index ? -1 : x->index > y->index;
}

/* Sorts the table. Returns where each entry has gone, by its old index; malloc'd. */
static int32_t *sort(void *table, size_t bytes, int32_t count, struct key *keys)
{
    int32_t *gone = xcalloc((size_t)count, sizeof *gone);
    char *old = xmalloc((size_t)count * bytes);
    if (count > 0) { /* an empty table has no address */
        memcpy(old, table, (size_t)count * bytes);
        qsort(keys, (size_t)count, sizeof *keys, by_key);
    }
    for (int32_t i = 0; i < count; i++) {
        memcpy((char *)table + (size_t)i * bytes, old + (size_t)keys[i].index * bytes, bytes);
        gone[keys[i].index] = i;
    }
    free(old);
    free(keys);
    return gone;
}

static struct key *room(int32_t count)
{
    return xcalloc((size_t)count, sizeof(struct key));
}

static int32_t *sort_calls(struct trace *t)
{
    struct key *k = room(t->call_count);
    for (int32_t i = 0; i < t->call_count; i++)
        k[i] = (struct key){t->calls[i].node, i, t->calls[i].begin, 0};
    return sort(t->calls, sizeof *t->calls, t->call_count, k);
}

static int32_t *sort_handlers(struct trace *t)
{
    struct key *k = room(t->handler_count);
    for (int32_t i = 0; i < t->handler_count; i++)
        k[i] = (struct key){t->handlers[i].node, i, t->handlers[i].begin, 0};
    return sort(t->handlers, sizeof *t->handlers, t->handler_count, k);
}

/* Those sent at one time: by their names, since the file has them in the order in which they arrived. */
static int32_t *sort_messages(struct loading *l)
{
    struct trace *t = l->t;
    struct key *k = room(t->message_count);
    for (const struct link *m = l->links; m < l->links + l->link_count; m++)
        if (m->kind == LINK_IS)
            k[m->index] =
                (struct key){0, m->index, t->messages[m->index].sent, (uint64_t)m->source << 40 | m->order};
    return sort(t->messages, sizeof *t->messages, t->message_count, k);
}

static void sort_systems(struct trace *t)
{
    struct key *k = room(t->system_count);
    for (int32_t i = 0; i < t->system_count; i++)
        k[i] = (struct key){t->systems[i].node, i, t->systems[i].charged, 0};
    free(sort(t->systems, sizeof *t->systems, t->system_count, k));
}

/* Waits stay in the order of their calls. */
static void sort_waits(struct trace *t, const int32_t *call_gone)
{
    struct key *k = room(t->wait_count);
    for (int32_t i = 0; i < t->wait_count; i++) {
        t->waits[i].call = call_gone[t->waits[i].call];
        k[i] = (struct key){t->waits[i].call, i, 0, 0};
    }
    int32_t *gone = sort(t->waits, sizeof *t->waits, t->wait_count, k);
    for (int32_t i = 0; i < t->call_count; i++)
        t->calls[i].first_wait = t->calls[i].waits ? gone[t->calls[i].first_wait] : 0;
    free(gone);
}

static void sort_blocks(struct trace *t, const int32_t *message_gone)
{
    struct key *k = room(t->block_count);
    for (int32_t i = 0; i < t->block_count; i++) {
        t->blocks[i].message = message_gone[t->blocks[i].message];
        k[i] = (struct key){t->blocks[i].message, i, 0, 0};
    }
    int32_t *gone = sort(t->blocks, sizeof *t->blocks, t->block_count, k);
    for (int32_t i = 0; i < t->message_count; i++)
        t->messages[i].first_block = t->messages[i].blocks ? gone[t->messages[i].first_block] : 0;
    free(gone);
}

/* Notes for each node where its entries are. */
#define PARTS(t, table)                                                                                      \
    for (int32_t i = (t)->table##_count; i-- > 0;) {                                                         \
        struct trace_node *n = &(t)->nodes[(t)->table##s[i].node];                                           \
        n->first_##table = i, n->table##s++;                                                                 \
    }

/* --- messages by name --- */

static int by_name(const void *a, const void *b)
{
    const struct link *x = a, *y = b;
    if (x->source != y->source)
        return x->source < y->source ? -1 : 1;
    if (x->order != y->order)
        return x->order < y->order ? -1 : 1;
    return x->kind < y->kind ? -1 : x->kind > y->kind;
}

/* The names of messages among the links, sorted. */
struct names {
    const struct link *list;
    size_t count;
};

/* The first message of that source whose order is not less; NULL: none. */
static const struct link *first_from(const struct names *n, uint32_t source, uint64_t order)
{
    size_t low = 0, high = n->count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        const struct link *at = &n->list[middle];
        if (at->source < source || (at->source == source && at->order < order))
            low = middle + 1;
        else
            high = middle;
    }
    return low < n->count && n->list[low].source == source ? &n->list[low] : NULL;
}

static int32_t message_named(const struct names *n, uint32_t source, uint64_t order)
{
    const struct link *found = first_from(n, source, order);
    return found && found->order == order ? found->index : TRACE_NONE;
}

static void connect_sends(struct trace *t, const struct names *names, const struct link *l)
{
    struct trace_call *c = &t->calls[l->index];
    const struct link *end = names->list + names->count;
    for (const struct link *m = first_from(names, l->source, l->order);
         m && m < end && m->source == l->source && m->order < l->order + l->count; m++) {
        t->messages[m->index].sending = l->index;
        if (c->sent == TRACE_NONE || m->index < c->sent)
            c->sent = m->index;
    }
}

static void connect_one(struct trace *t, const struct names *names, const struct link *l)
{
    int32_t m = message_named(names, l->source, l->order);
    if (l->kind == LINK_TAKES)
        t->calls[l->index].taken = m;
    else
        t->handlers[l->index].message = m;
    if (m == TRACE_NONE)
        return;
    t->messages[m].taken = l->at;
    if (l->kind == LINK_TAKES)
        t->messages[m].taking = l->index;
}

static void connect_messages(struct loading *l)
{
    struct link *named = xcalloc(l->link_count, sizeof *named);
    struct names names = {named, 0};
    for (size_t i = 0; i < l->link_count; i++)
        if (l->links[i].kind == LINK_IS)
            named[names.count++] = l->links[i];
    qsort(named, names.count, sizeof *named, by_name);
    for (const struct link *k = l->links; k < l->links + l->link_count; k++)
        if (k->kind == LINK_SENDS)
            connect_sends(l->t, &names, k);
        else if (k->kind != LINK_IS)
            connect_one(l->t, &names, k);
    free(named);
}

void trace_connect(struct loading *l)
{
    struct trace *t = l->t;
    int32_t *call_gone = sort_calls(t), *handler_gone = sort_handlers(t), *message_gone = sort_messages(l);
    const int32_t *const gone[] = {[LINK_IS] = message_gone,
                                   [LINK_SENDS] = call_gone,
                                   [LINK_TAKES] = call_gone,
                                   [LINK_HANDLES] = handler_gone};
    sort_systems(t);
    sort_waits(t, call_gone);
    sort_blocks(t, message_gone);
    PARTS(t, call)
    PARTS(t, wait)
    PARTS(t, handler)
    PARTS(t, system)
    for (struct link *k = l->links; k < l->links + l->link_count; k++)
        k->index = gone[k->kind][k->index];
    connect_messages(l);
    free(call_gone);
    free(handler_gone);
    free(message_gone);
}
