/* trace_load.c - reads a trace file into tables: see trace_model.h and trace/trace_format.h.
 *
 * The file names a message by its source and its order there. The reader collects all that it selects,
 * sorts the tables, and then replaces such names by indexes. */
#include <errno.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "files/words.h"
#include "kernel/xalloc.h"
#include "lab/trace/trace_parts.h"
#include "trace/trace_format.h"
#include "trace/unpacker.h"

enum { LONGEST_TEXT = 1 << 24, DEEPEST_STACK = 64 };

/* --- the head --- */

static char *text_of(const json_t *head, const char *key)
{
    const char *text = json_string_value(json_object_get(head, key));
    return xstrdup(text ? text : "");
}

static uint32_t number_of(const json_t *object, const char *key)
{
    return (uint32_t)json_integer_value(json_object_get(object, key));
}

/* Ended by NULL. */
static char **words_of(const json_t *list)
{
    char **words = xcalloc(json_array_size(list) + 1, sizeof *words);
    for (size_t i = 0; i < json_array_size(list); i++) {
        const char *word = json_string_value(json_array_get(list, i));
        words[i] = xstrdup(word ? word : "");
    }
    return words;
}

static void read_command(struct trace *t, const json_t *list)
{
    size_t size;
    FILE *joined = xchecked(open_memstream(&t->command, &size));
    t->argv = words_of(list);
    for (size_t i = 0; t->argv[i]; i++)
        fprintf(joined, "%s%s", i ? " " : "", t->argv[i]);
    fclose(joined);
}

/* Makes the shape that the run had. False: there is none such. */
static bool read_network(struct topo *t, const json_t *o, uint32_t nodes)
{
    const char *shape = json_string_value(json_object_get(o, "shape"));
    bool mesh = shape && !strcmp(shape, "mesh"), host = json_is_true(json_object_get(o, "host"));
    uint32_t services = number_of(o, "services"), rows = number_of(o, "rows"),
             columns = number_of(o, "columns"), addresses = number_of(o, "addresses");
    if (nodes > TOPO_ADDRESSES || rows > TOPO_ADDRESSES || columns > TOPO_ADDRESSES ||
        services > TOPO_ADDRESSES || addresses > TOPO_ADDRESSES || (mesh && host))
        return false;
    if (!(mesh ? topo_mesh(t, nodes, rows, columns) : topo_hypercube(t, nodes, 20)))
        return false;
    topo_add_services(t, services);
    if (host)
        topo_add_host(t);
    return t->addresses == addresses;
}

static void make_nodes(struct trace *t, uint32_t nodes, const json_t *traced)
{
    t->node_count = (int32_t)(nodes + t->topo.host);
    t->nodes = xcalloc((size_t)t->node_count, sizeof *t->nodes);
    for (uint32_t i = 0; i < (uint32_t)t->node_count; i++) {
        struct trace_node *n = &t->nodes[i];
        bool host = i == nodes;
        n->address = host ? topo_host(&t->topo) : i;
        n->traced = !traced;
        snprintf(n->name, sizeof n->name, host ? "host" : "node %u", i);
    }
    for (size_t i = 0; i < json_array_size(traced); i++) {
        json_int_t number = json_integer_value(json_array_get(traced, i));
        if (number >= 0 && number < t->node_count)
            t->nodes[number].traced = true;
    }
}

static bool read_head(struct trace *t, const char *text)
{
    json_t *head = json_loads(text, 0, NULL);
    const json_t *network = json_object_get(head, "network"), *to = json_object_get(head, "to");
    uint32_t nodes = number_of(network, "nodes");
    bool good = head && nodes && read_network(&t->topo, network, nodes);
    if (good) {
        t->program = text_of(head, "program"), t->machine = text_of(head, "machine");
        t->folder = text_of(head, "folder"), t->version = text_of(head, "version");
        read_command(t, json_object_get(head, "command"));
        t->layer = words_of(json_object_get(head, "layer"));
        make_nodes(t, nodes, json_object_get(head, "traced"));
        t->from = (vtime)json_integer_value(json_object_get(head, "from"));
        t->to = to ? (vtime)json_integer_value(to) : VT_NEVER;
    }
    json_decref(head);
    return good;
}

/* --- records --- */

int32_t trace_node_at(const struct trace *t, uint32_t address)
{
    uint32_t programs = (uint32_t)t->node_count - t->topo.host;
    return address < programs                ? (int32_t)address
           : topo_is_host(&t->topo, address) ? t->node_count - 1
                                             : TRACE_NONE;
}

bool trace_node_ran(const struct trace *t, int32_t node)
{
    const struct trace_node *n = &t->nodes[node];
    return !t->topo.host || !n->traced || topo_is_host(&t->topo, n->address) || n->calls || n->handlers ||
           n->systems || (t->complete && n->end > 0);
}

int32_t trace_nodes_ran(const struct trace *t)
{
    int32_t count = 0;
    for (int32_t i = 0; i < t->node_count; i++)
        count += trace_node_ran(t, i) && !topo_is_host(&t->topo, t->nodes[i].address);
    return count;
}

bool trace_selects(const struct trace *t, const struct trace_selection *s, int32_t node)
{
    return !s->nodes || ((uint32_t)node < s->node_count && s->nodes[node]) ||
           (s->host && topo_is_host(&t->topo, t->nodes[node].address));
}

bool trace_has_nodes(const struct trace *t, const struct trace_selection *s, char **error)
{
    for (int32_t i = 0; i < t->node_count; i++)
        if (trace_selects(t, s, i))
            return true;
    *error = xasprintf("%s has none of these nodes: it has nodes 0 to %d%s", t->path,
                       t->node_count - 1 - t->topo.host, t->topo.host ? " and the host" : "");
    return false;
}

/* Is a node selected? */
static bool wants(const struct loading *l, int32_t node)
{
    return node != TRACE_NONE && trace_selects(l->t, l->selection, node);
}

static bool wants_time(const struct loading *l, vtime begin, vtime end)
{
    return end >= l->selection->from && (!l->selection->to || begin <= l->selection->to);
}

/* The node at an address that a record is about; a wrong one spoils the file. */
static int32_t node_of_record(struct loading *l, uint64_t address)
{
    int32_t node = address < l->t->topo.addresses ? trace_node_at(l->t, (uint32_t)address) : TRACE_NONE;
    if (node == TRACE_NONE)
        l->bad = true, node = 0;
    return node;
}

/* The index of one of a table's `count` entries. */
static int32_t read_index(struct loading *l, int32_t count)
{
    uint64_t index = unpack(l->in);
    l->bad |= index >= (uint64_t)count;
    return (int32_t)index;
}

/* The index of a stack; TRACE_NONE: not known. */
static int32_t read_stack_index(struct loading *l)
{
    return read_index(l, trace_stacks_count(l->t->stacks) + 1) - 1;
}

static vtime since(vtime *last, int64_t difference)
{
    return *last += (vtime)difference;
}

/* A time that is so much later; what is beyond all times spoils the file. */
static vtime later(struct loading *l, vtime *last)
{
    vtime before = *last;
    *last += unpack(l->in);
    l->bad |= *last < before;
    return *last;
}

/* Keeps a table's next entry; the tables grow by doubling. */
#define ADD(l, table, entry)                                                                                 \
    do {                                                                                                     \
        (l)->t->table##s =                                                                                   \
            xgrown((l)->t->table##s, (size_t)(l)->t->table##_count, sizeof *(l)->t->table##s);               \
        (l)->t->table##s[(l)->t->table##_count++] = (entry);                                                 \
    } while (0)

static void keep_link(struct loading *l, struct link link)
{
    l->links = xgrown(l->links, l->link_count, sizeof *l->links);
    l->links[l->link_count++] = link;
}

static void read_waits(struct loading *l, struct trace_call *c, bool wanted)
{
    uint64_t count = unpack(l->in);
    vtime at = c->begin;
    c->first_wait = l->t->wait_count;
    for (uint64_t i = 0; i < count && unpacker_good(l->in); i++) {
        struct trace_wait w = {.node = c->node, .call = l->t->call_count, .from = TRACE_NONE};
        w.begin = later(l, &at);
        w.end = later(l, &at);
        uint64_t busy = unpack(l->in);
        l->bad |= busy > w.end - w.begin;
        w.idle = w.end - w.begin - busy;
        uint8_t flags = unpack_byte(l->in);
        w.has_type = flags & WAIT_HAS_TYPE, w.sends = flags & WAIT_SENDS;
        if (w.has_type)
            w.type = (int32_t)unpack_signed(l->in);
        if (flags & WAIT_HAS_FROM)
            w.from = (int32_t)unpack(l->in);
        l->bad |= w.from < TRACE_NONE || w.from >= l->t->node_count;
        if (wanted)
            ADD(l, wait, w);
    }
    c->waits = l->t->wait_count - c->first_wait;
}

static void read_call(struct loading *l)
{
    struct unpacker *in = l->in;
    struct trace_call c = {.sent = TRACE_NONE, .taken = TRACE_NONE};
    uint64_t order = 0, count = 0, taken_source = 0, taken_order = 0, before_end = 0;
    c.node = node_of_record(l, unpack(in));
    uint8_t flags = unpack_byte(in);
    c.has_type = flags & CALL_HAS_TYPE, c.unfinished = flags & CALL_UNFINISHED,
    c.in_handler = flags & CALL_IN_HANDLER, c.continues = flags & CALL_CONTINUES;
    c.name = read_index(l, l->t->name_count);
    c.stack = read_stack_index(l);
    if (c.has_type)
        c.type = (int32_t)unpack_signed(in);
    c.begin = since(&l->last[c.node], unpack_signed(in));
    c.end = later(l, &l->last[c.node]);
    c.ordered = c.begin + unpack(in);
    if (flags & CALL_SENT)
        order = unpack(in), count = unpack(in);
    if (flags & CALL_TOOK)
        taken_source = unpack(in), taken_order = unpack(in), before_end = unpack(in);
    bool wanted = wants(l, c.node) && wants_time(l, c.begin, c.end) && !l->bad;
    read_waits(l, &c, wanted);
    if (!wanted)
        return;
    if (flags & CALL_SENT)
        keep_link(l,
                  (struct link){LINK_SENDS, l->t->call_count, l->t->nodes[c.node].address, order, count, 0});
    if (flags & CALL_TOOK)
        keep_link(l, (struct link){LINK_TAKES, l->t->call_count, (uint32_t)taken_source, taken_order, 1,
                                   c.end - before_end});
    ADD(l, call, c);
}

static void read_handler(struct loading *l)
{
    struct unpacker *in = l->in;
    struct trace_handler h = {.message = TRACE_NONE};
    uint64_t source = 0, order = 0;
    h.node = node_of_record(l, unpack(in));
    uint8_t flags = unpack_byte(in);
    h.unfinished = flags & HANDLER_UNFINISHED;
    h.type = (int32_t)unpack_signed(in);
    h.stack = read_stack_index(l);
    h.begin = since(&l->last[h.node], unpack_signed(in));
    h.due = h.begin - unpack(in);
    h.entered = later(l, &l->last[h.node]);
    h.left = later(l, &l->last[h.node]);
    h.end = later(l, &l->last[h.node]);
    if (flags & HANDLER_HAS_MESSAGE)
        source = unpack(in), order = unpack(in);
    if (!wants(l, h.node) || !wants_time(l, h.begin, h.end))
        return;
    if (flags & HANDLER_HAS_MESSAGE)
        keep_link(l, (struct link){LINK_HANDLES, l->t->handler_count, (uint32_t)source, order, 1, h.begin});
    ADD(l, handler, h);
}

/* Traces have what messages cause: the tasks 0 and 1, and the last two, of enum node_task. */
static bool task_of(uint64_t task, enum trace_task *result)
{
    static const int8_t TASKS[] = {TRACE_SENDING, TRACE_RECEIVING, -1, -1, -1, TRACE_FEEDING, TRACE_EMPTYING};
    if (task >= sizeof TASKS || TASKS[task] < 0)
        return false;
    *result = (enum trace_task)TASKS[task];
    return true;
}

static void read_system(struct loading *l)
{
    struct trace_system s = {0};
    s.node = node_of_record(l, unpack(l->in));
    l->bad |= !task_of(unpack(l->in), &s.task);
    s.charged = since(&l->last_system[s.node], unpack_signed(l->in));
    s.begin = later(l, &l->last_system[s.node]);
    s.end = later(l, &l->last_system[s.node]);
    if (s.end > s.begin && wants(l, s.node) && wants_time(l, s.begin, s.end))
        ADD(l, system, s);
}

static void read_blocks(struct loading *l, struct trace_message *m, bool wanted)
{
    uint64_t count = unpack(l->in);
    vtime at = m->entered;
    m->first_block = l->t->block_count;
    for (uint64_t i = 0; i < count && unpacker_good(l->in); i++) {
        struct trace_block b = {.message = l->t->message_count, .channel = (uint32_t)unpack(l->in)};
        b.begin = later(l, &at);
        uint64_t duration = unpack(l->in);
        l->bad |= duration && at + duration - 1 < at;
        b.end = duration ? (at += duration - 1) : VT_NEVER;
        l->bad |= b.channel >= l->t->topo.channels;
        if (wanted && !l->bad)
            ADD(l, block, b);
    }
    m->blocks = l->t->block_count - m->first_block;
}

static void read_message(struct loading *l)
{
    struct unpacker *in = l->in;
    struct trace_message m = {.taken = VT_NEVER, .sending = TRACE_NONE, .taking = TRACE_NONE};
    vtime times[MESSAGE_TIMES];
    uint32_t source = (uint32_t)unpack(in);
    uint64_t order = unpack(in);
    m.from_address = (uint32_t)unpack(in), m.to_address = (uint32_t)unpack(in);
    uint64_t flags = unpack(in);
    m.is_long = flags & MESSAGE_LONG;
    m.type = (int32_t)unpack_signed(in);
    m.bytes = unpack(in);
    m.pid = flags & MESSAGE_HAS_PID ? (int32_t)unpack_signed(in) : 0;
    vtime at = m.sent = since(&l->last_sent, unpack_signed(in));
    for (int i = 0; i < MESSAGE_TIMES; i++)
        times[i] = flags & (uint64_t)MESSAGE_FIRST_TIME << i ? (at += (vtime)unpack_signed(in)) : VT_NEVER;
    m.asked = times[MESSAGE_ASKED], m.granted = times[MESSAGE_GRANTED], m.entered = times[MESSAGE_ENTERED];
    m.moved = times[MESSAGE_MOVED], m.freed = times[MESSAGE_FREED], m.left = times[MESSAGE_LEFT];
    m.complete = times[MESSAGE_COMPLETE];
    l->bad |= m.from_address >= l->t->topo.addresses || m.to_address >= l->t->topo.addresses;
    if (l->bad)
        return;
    m.from = trace_node_at(l->t, m.from_address), m.to = trace_node_at(l->t, m.to_address);
    bool wanted = (wants(l, m.from) || wants(l, m.to)) && wants_time(l, m.sent, m.complete);
    read_blocks(l, &m, wanted);
    if (!wanted)
        return;
    keep_link(l, (struct link){LINK_IS, l->t->message_count, source, order, 1, 0});
    ADD(l, message, m);
}

static void read_stack(struct loading *l)
{
    int64_t offsets[DEEPEST_STACK], at = 0;
    uint64_t program = unpack(l->in), depth = unpack(l->in);
    l->bad |= depth > DEEPEST_STACK || program >= (uint64_t)trace_stacks_programs(l->t->stacks);
    for (uint64_t i = 0; i < depth && !l->bad; i++)
        offsets[i] = at += unpack_signed(l->in);
    if (!l->bad)
        trace_stacks_add(l->t->stacks, (int)program, offsets, (int)depth);
}

static void read_name(struct loading *l)
{
    struct trace *t = l->t;
    t->names = xreallocarray(t->names, (size_t)t->name_count + 1, sizeof *t->names);
    t->classes = xreallocarray(t->classes, (size_t)t->name_count + 1, sizeof *t->classes);
    t->names[t->name_count] = unpack_text(l->in, LONGEST_TEXT);
    t->classes[t->name_count] = trace_class_of(t->names[t->name_count]);
    t->name_count++;
}

static void read_end(struct loading *l)
{
    l->t->end = unpack(l->in);
    for (int i = 0; i < 8; i++)
        l->t->digest |= (uint64_t)unpack_byte(l->in) << 8 * i;
    l->t->complete = unpacker_good(l->in);
}

static void read_node_end(struct loading *l)
{
    int32_t node = node_of_record(l, unpack(l->in));
    l->t->nodes[node].end = unpack(l->in);
}

static void read_program(struct loading *l)
{
    char *path = unpack_text(l->in, LONGEST_TEXT);
    trace_stacks_program(l->t->stacks, l->t->folder, path);
    free(path);
}

static void read_records(struct loading *l)
{
    static void (*const READ[RECORD_KINDS])(struct loading *) = {
        [RECORD_END] = read_end,       [RECORD_NAME] = read_name,       [RECORD_PROGRAM] = read_program,
        [RECORD_STACK] = read_stack,   [RECORD_CALL] = read_call,       [RECORD_HANDLER] = read_handler,
        [RECORD_SYSTEM] = read_system, [RECORD_MESSAGE] = read_message, [RECORD_NODE_END] = read_node_end};
    while (!l->bad && !l->t->complete) {
        uint8_t kind = unpack_byte(l->in);
        if (!unpacker_good(l->in))
            return; /* the file ends early */
        if (kind >= RECORD_KINDS)
            l->bad = true;
        else
            READ[kind](l);
    }
}

/* --- the whole --- */

static struct trace *fail(struct loading *l, char **error, const char *what)
{
    *error = xasprintf("%s: %s", l->t->path, what);
    trace_free(l->t);
    return NULL;
}

static void free_loading(struct loading *l)
{
    unpacker_free(l->in);
    free(l->links);
    free(l->last);
    free(l->last_system);
}

/* The trace has what is between both, the run's own limits and the selection's. */
static void set_interval(struct trace *t, const struct trace_selection *s)
{
    if (!t->complete)
        for (int32_t i = 0; i < t->call_count; i++)
            t->end = vt_max(t->end, t->calls[i].end);
    t->from = vt_max(t->from, s->from);
    t->to = vt_min(vt_min(t->to, s->to ? s->to : VT_NEVER), t->end);
    t->from = vt_min(t->from, t->to);
    for (int32_t i = 0; i < t->node_count; i++) {
        struct trace_node *n = &t->nodes[i];
        n->traced = n->traced && trace_selects(t, s, i);
        if (!t->complete)
            n->end = t->end;
    }
}

static struct trace *load(FILE *in, struct loading *l, char **error)
{
    char magic[sizeof TRACE_MAGIC] = "";
    if (!fgets(magic, sizeof magic, in) || strcmp(magic, TRACE_MAGIC))
        return fail(l, error, "not a trace of touchstone run --trace, or of another version of it");
    char *head = unpack_text(l->in, LONGEST_TEXT);
    bool good = unpacker_good(l->in) && read_head(l->t, head);
    free(head);
    if (!good)
        return fail(l, error, "the trace's head is damaged");
    if (!trace_has_nodes(l->t, l->selection, error))
        return trace_free(l->t), NULL;
    l->last = xcalloc((size_t)l->t->node_count, sizeof *l->last);
    l->last_system = xcalloc((size_t)l->t->node_count, sizeof *l->last_system);
    read_records(l);
    if (l->bad)
        return fail(l, error, "the trace is damaged");
    set_interval(l->t, l->selection);
    trace_connect(l);
    return l->t;
}

struct trace *trace_load(const char *path, const struct trace_selection *s, char **error)
{
    static const struct trace_selection ALL = {0};
    FILE *in = strcmp(path, "-") ? fopen(path, "rb") : stdin;
    if (!in) {
        *error = xasprintf("%s cannot be read: %s", path, strerror(errno));
        return NULL;
    }
    struct loading l = {.t = xcalloc(1, sizeof *l.t), .selection = s ? s : &ALL, .in = unpacker_new(in)};
    l.t->path = xstrdup(path);
    l.t->stacks = trace_stacks_new();
    struct trace *t = load(in, &l, error);
    free_loading(&l);
    if (in != stdin)
        fclose(in);
    return t;
}

void trace_free(struct trace *t)
{
    if (!t)
        return;
    for (int32_t i = 0; i < t->name_count; i++)
        free(t->names[i]);
    words_free(t->argv);
    words_free(t->layer);
    void *const parts[] = {t->path,    t->program,  t->machine, t->command,  t->folder,
                           t->version, t->names,    t->classes, t->nodes,    t->calls,
                           t->waits,   t->handlers, t->systems, t->messages, t->blocks};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        free(parts[i]);
    trace_stacks_free(t->stacks);
    free(t);
}
