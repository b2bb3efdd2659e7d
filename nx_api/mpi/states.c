/* states.c - see states.h. A WIRE_STATE is
 *
 *     struct flat | messages | receives | taken          as many of each as the counts in struct flat say
 *
 * with no pointers that are valid elsewhere: texts are in the structs, places are addresses. */
#include "nx_api/mpi/states.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "nx_api/calls/awaited.h"
#include "nx_api/contract/ids.h"
#include "nx_api/mpi/past_messages.h"
#include "nx_api/mpi/lines.h"
#include "nx_api/mpi/mpi_mailbox.h"
#include "nx_api/mpi/mpi_node.h"
#include "nx_api/mpi/mpi_wire.h"
#include "nx_api/mpi/shared_pointer.h"
#include "nx_api/mpi/stack.h"

enum { MOST_FRAMES = 24, MOST_CALL = 24 };

struct flat {
    struct waitfor_node node;
    char call[MOST_CALL]; /* "": none */
    size_t frames;
    uint64_t stack[MOST_FRAMES];
};

struct flat_receive {
    struct waitfor_receive receive;
    uint64_t where;
};

struct flat_taken {
    struct waitfor_taken taken;
    char call[MOST_CALL];
    uint64_t where;
};

static const double PS = 1e12;

/* --- what this node waits for --- */

static struct waitfor_select plain(const struct selector *s)
{
    return (struct waitfor_select){(long)s->type, s->node, s->pid};
}

static void tell_wait(struct node *n, struct waitfor_node *node)
{
    struct awaited a = nx_awaited(n, n->ready, n->ready_for);
    bool file = shared_is_awaited(n->ready); /* where no handler runs */
    node->what = file ? WAITFOR_FILE : WAITFOR_OTHER;
    node->in_handler = n->in_handler && !file;
    if (a.receive || a.probe) {
        node->what = WAITFOR_MESSAGE;
        node->select = plain(a.receive ? &a.receive->select : a.probe);
    } else if (a.end) {
        node->what = WAITFOR_END;
        node->to = a.of == ALL_NODES ? WAITFOR_ANY : a.of;
        node->of_all = a.all && a.of == ALL_NODES;
    }
}

static void tell_node(struct node *n, struct flat *f)
{
    struct waitfor_node *node = &f->node;
    node->state = n->over ? WAITFOR_ENDED : WAITFOR_WAITS;
    node->since_ps = (uint64_t)(n->since * PS);
    if (n->over)
        return;
    if (n->call.name)
        strncpy(f->call, n->call.name, MOST_CALL - 1);
    node->has_type = n->call.has_type, node->type = n->call.type;
    node->masked = n->masked;
    f->frames = stack_walk(f->stack, MOST_FRAMES);
    tell_wait(n, node);
}

/* --- what is in its mailbox --- */

static void write_messages(struct node *n, struct waitfor_node *node, FILE *f)
{
    struct waitfor_node list = {0};
    for (const struct message *m = mpi_mailbox_unexpected(n); m; m = m->next)
        waitfor_add_message(&list, &(struct waitfor_message){m->type, m->source, m->pid, m->bytes,
                                                             WAITFOR_NEVER, WAITFOR_NEVER, false, false});
    if (list.message_count)
        fwrite(list.messages, sizeof *list.messages, list.message_count, f);
    node->message_count = list.message_count, node->more_messages = list.more_messages;
    free(list.messages);
}

static void write_receive(const struct receive *r, struct waitfor_node *node, FILE *f)
{
    uintptr_t where = r->handler ? (uintptr_t)r->handler + 1 : r->place;
    struct flat_receive flat = {{.select = plain(&r->select), .has_handler = r->handler, .filled = r->m},
                                stack_in_file(where)};
    if (r->m)
        flat.receive.type = r->m->type, flat.receive.from = r->m->source;
    fwrite(&flat, sizeof flat, 1, f);
    node->receive_count++;
}

/* Writes the receives of message ids, and the receives with handlers, posted or due. */
static void write_receives(struct node *n, struct waitfor_node *node, FILE *f)
{
    const struct receive *r;
    for (const struct id_block *b = mailbox_ids(n)->first; b; b = b->next)
        for (int i = 0; i < IDS_BLOCK; i++)
            if (b->ids[i].use & ID_RECEIVES)
                write_receive(&b->ids[i].receive, node, f);
    for (r = mpi_mailbox_posted(n); r; r = r->next)
        if (r->handler)
            write_receive(r, node, f);
    for (unsigned i = 0; mpi_mailbox_due(n, i, &r); i++) {
        node->due++;
        if (r)
            write_receive(r, node, f);
    }
}

static void write_taken(struct waitfor_node *node, FILE *f)
{
    const struct past_item *h;
    for (unsigned i = 0; (h = past_at(i)); i++) {
        struct flat_taken flat = {
            .taken = {h->fate, h->type, h->from, h->pid, h->bytes, plain(&h->by), NULL, NULL, WAITFOR_NEVER},
            .where = stack_in_file(h->place)};
        if (h->call)
            strncpy(flat.call, h->call, MOST_CALL - 1);
        fwrite(&flat, sizeof flat, 1, f);
        node->taken_count++;
    }
}

void states_tell(struct node *n)
{
    char *bytes;
    size_t count;
    struct flat flat = {0};
    FILE *f = open_memstream(&bytes, &count);
    if (!f)
        node_fail(n, "out of memory");
    tell_node(n, &flat);
    fwrite(&flat, sizeof flat, 1, f);
    write_messages(n, &flat.node, f);
    write_receives(n, &flat.node, f);
    write_taken(&flat.node, f);
    fclose(f);
    memcpy(bytes, &flat, sizeof flat); /* with the counts */
    wire_send(n, 0, (struct wire_head){.kind = WIRE_STATE}, bytes, count);
    free(bytes);
}

/* --- node 0's side --- */

/* The answers, by node. */
static void **answers;
static uint32_t heard;

void states_heard(uint32_t source, const void *bytes, size_t count)
{
    answers[source] = malloc(count);
    if (!answers[source])
        abort();
    memcpy(answers[source], bytes, count);
    heard++;
}

static void ask_all(struct node *n)
{
    answers = calloc(n->sys->count, sizeof *answers);
    if (!answers)
        node_fail(n, "out of memory");
    wire_send(n, ALL_NODES, (struct wire_head){.kind = WIRE_ASK}, NULL, 0);
    states_tell(n);
    while (heard < n->sys->count) {
        wire_progress(n);
        nanosleep(&(struct timespec){.tv_nsec = 50000}, NULL);
    }
}

static const struct flat_receive *receives_of(const struct flat *f)
{
    return (const void *)((const struct waitfor_message *)(f + 1) + f->node.message_count);
}

static const struct flat_taken *taken_of(const struct flat *f)
{
    return (const void *)(receives_of(f) + f->node.receive_count);
}

/* The source lines of all places in the report. */
static struct lines *find_lines(uint32_t nodes)
{
    size_t count = 0, most = 0;
    for (uint32_t i = 0; i < nodes; i++) {
        const struct flat *f = answers[i];
        most += f->frames + f->node.receive_count + f->node.taken_count;
    }
    uint64_t *places = calloc(most + 1, sizeof *places);
    if (!places)
        abort();
    for (uint32_t i = 0; i < nodes; i++) {
        const struct flat *f = answers[i];
        for (size_t k = 0; k < f->frames; k++)
            places[count++] = f->stack[k];
        for (size_t k = 0; k < f->node.receive_count; k++)
            places[count++] = receives_of(f)[k].where;
        for (size_t k = 0; k < f->node.taken_count; k++)
            places[count++] = taken_of(f)[k].where;
    }
    struct lines *l = lines_find(places, count);
    free(places);
    return l;
}

/* Without that of the C library's start-up. */
static void read_stack(struct waitfor *w, struct waitfor_node *node, const struct flat *f,
                       const struct lines *l)
{
    for (size_t i = 0; i < f->frames; i++) {
        char frame[300];
        const char *function = lines_function(l, f->stack[i]), *line = lines_at(l, f->stack[i]);
        if (function && strcmp(function, "_start") == 0)
            break;
        if (i == 0)
            node->line = waitfor_text(w, line);
        snprintf(frame, sizeof frame, "%s()%s%s", function ? function : "?", line ? " at " : "",
                 line ? line : "");
        waitfor_add_frame(w, node, frame);
    }
}

static void read_node(struct waitfor *w, struct waitfor_node *node, const struct flat *f,
                      const struct lines *l)
{
    const struct waitfor_node own = *node;
    const struct waitfor_message *m = (const void *)(f + 1);
    *node = f->node;
    node->name = own.name, node->number = own.number;
    node->call = f->call[0] ? waitfor_text(w, f->call) : NULL;
    node->message_count = node->receive_count = node->taken_count = 0;
    for (size_t i = 0; i < f->node.message_count; i++)
        waitfor_add_message(node, &m[i]);
    for (size_t i = 0; i < f->node.receive_count; i++) {
        struct waitfor_receive r = receives_of(f)[i].receive;
        r.line = waitfor_text(w, lines_at(l, receives_of(f)[i].where));
        waitfor_add_receive(node, &r);
    }
    for (size_t i = 0; i < f->node.taken_count; i++) {
        const struct flat_taken *flat = &taken_of(f)[i];
        struct waitfor_taken t = flat->taken;
        t.call = flat->call[0] ? waitfor_text(w, flat->call) : NULL;
        t.line = waitfor_text(w, lines_at(l, flat->where));
        waitfor_add_taken(node, &t);
    }
    read_stack(w, node, f, l);
}

struct waitfor *states_gather(struct node *n)
{
    ask_all(n);
    struct waitfor *w = waitfor_new(n->sys->count);
    struct lines *l = find_lines(n->sys->count);
    w->program = waitfor_text(w, program_invocation_short_name);
    w->now_ps = (uint64_t)(mpi_seconds() * PS);
    w->clock = "time since the program began";
    for (uint32_t i = 0; i < w->count; i++) {
        read_node(w, &w->nodes[i], answers[i], l);
        free(answers[i]);
    }
    free(answers);
    lines_free(l);
    return w;
}
