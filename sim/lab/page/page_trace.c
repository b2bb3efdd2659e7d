/* page_trace.c - see page_trace.h. */
#include "lab/page/page_trace.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/page/data_columns.h"
#include "lab/page/page_channels.h"
#include "lab/page/page_texts.h"
#include "observe/json_file.h"

enum { MOST_COLUMNS = 80 };

/* A trace, and what is made of it for the page. */
struct traced {
    const struct trace *t;
    struct trace_pieces pieces;
    int32_t *worked; /* by piece: the text of the functions that computed; TRACE_NONE */
    struct page_texts *texts;
    struct page_channels channels;
    struct column columns[MOST_COLUMNS];
    size_t count;
};

/* --- values of the columns ------------------------------------------------------------------------------ */

/* A function that gets `expression` of place i of `list`, whose trace is t. */
#define VALUE(function, type, list, expression)                                                              \
    static uint64_t function(const void *of, size_t i)                                                       \
    {                                                                                                        \
        const struct traced *traced = of;                                                                    \
        const struct type *x = &traced->list[i];                                                             \
        return (uint64_t)(expression);                                                                       \
    }
#define PIECE(member, expression) VALUE(piece_##member, trace_piece, pieces.list, expression)
#define CALL(member, expression) VALUE(call_##member, trace_call, t->calls, expression)
#define WAIT(member, expression) VALUE(wait_##member, trace_wait, t->waits, expression)
#define HANDLER(member, expression) VALUE(handler_##member, trace_handler, t->handlers, expression)
#define SYSTEM(member, expression) VALUE(system_##member, trace_system, t->systems, expression)
#define MESSAGE(member, expression) VALUE(message_##member, trace_message, t->messages, expression)
#define BLOCK(member, expression) VALUE(block_##member, trace_block, t->blocks, expression)

PIECE(end, x->end)
PIECE(state, x->state | (unsigned)x->in_handler << 3)
PIECE(call, x->call)
PIECE(wait, x->state == TRACE_WAITING ? x->wait : TRACE_NONE)
PIECE(handler, x->in_handler ? x->handler : TRACE_NONE)
PIECE(system, x->state == TRACE_IN_SYSTEM ? x->system : TRACE_NONE)
PIECE(worked, traced->worked[x - traced->pieces.list])

CALL(begin, x->begin)
CALL(end, x->end)
CALL(node, x->node)
CALL(name, x->name)
CALL(called, page_texts_called(traced->texts, x))
CALL(place, page_texts_place(traced->texts, x->stack))
CALL(type, x->type)
CALL(flags, x->has_type | x->unfinished << 1 | x->in_handler << 2)
CALL(sent, x->sent)
CALL(taken, x->taken)

WAIT(type, x->type)
WAIT(from, x->from)
WAIT(flags, x->has_type | x->sends << 1)

HANDLER(due, x->due)
HANDLER(type, x->type)
HANDLER(message, x->message)
HANDLER(place, page_texts_place(traced->texts, x->stack))

SYSTEM(task, x->task)

MESSAGE(from, x->from)
MESSAGE(to, x->to)
MESSAGE(from_address, x->from_address)
MESSAGE(to_address, x->to_address)
MESSAGE(type, x->type)
MESSAGE(pid, x->pid)
MESSAGE(bytes, x->bytes)
MESSAGE(flags, x->is_long)
MESSAGE(sent, x->sent)
MESSAGE(asked, x->asked)
MESSAGE(granted, x->granted)
MESSAGE(entered, x->entered)
MESSAGE(moved, x->moved)
MESSAGE(freed, x->freed)
MESSAGE(left, x->left)
MESSAGE(complete, x->complete)
MESSAGE(taken, x->taken)
MESSAGE(sending, x->sending)
MESSAGE(taking, x->taking)

BLOCK(begin, x->begin)
BLOCK(end, x->end)
BLOCK(message, x->message)
BLOCK(channel, x->channel)

/* --- the columns ---------------------------------------------------------------------------------------- */

static void add(struct traced *d, const char *name, enum column_type type, size_t count, column_value *value,
                const char *base)
{
    d->columns[d->count++] = (struct column){name, type, count, value, d, base};
}

static void add_pieces(struct traced *d)
{
    size_t n = d->pieces.count;
    add(d, "piece.end", COLUMN_U64, n, piece_end, "");
    add(d, "piece.state", COLUMN_U8, n, piece_state, NULL);
    add(d, "piece.call", COLUMN_I32, n, piece_call, "");
    add(d, "piece.wait", COLUMN_I32, n, piece_wait, NULL);
    add(d, "piece.handler", COLUMN_I32, n, piece_handler, NULL);
    add(d, "piece.system", COLUMN_I32, n, piece_system, NULL);
    add(d, "piece.worked", COLUMN_I32, n, piece_worked, NULL);
    add(d, "system.task", COLUMN_U8, (size_t)d->t->system_count, system_task, NULL);
}

static void add_calls(struct traced *d)
{
    size_t n = (size_t)d->t->call_count, waits = (size_t)d->t->wait_count,
           handlers = (size_t)d->t->handler_count;
    add(d, "call.begin", COLUMN_U64, n, call_begin, "");
    add(d, "call.end", COLUMN_U64, n, call_end, "call.begin");
    add(d, "call.node", COLUMN_I32, n, call_node, "");
    add(d, "call.name", COLUMN_U16, n, call_name, NULL);
    add(d, "call.called", COLUMN_I32, n, call_called, NULL);
    add(d, "call.place", COLUMN_I32, n, call_place, NULL);
    add(d, "call.type", COLUMN_I32, n, call_type, NULL);
    add(d, "call.flags", COLUMN_U8, n, call_flags, NULL);
    add(d, "call.sent", COLUMN_I32, n, call_sent, NULL);
    add(d, "call.taken", COLUMN_I32, n, call_taken, NULL);
    add(d, "wait.type", COLUMN_I32, waits, wait_type, NULL);
    add(d, "wait.from", COLUMN_I32, waits, wait_from, NULL);
    add(d, "wait.flags", COLUMN_U8, waits, wait_flags, NULL);
    add(d, "handler.due", COLUMN_U64, handlers, handler_due, "");
    add(d, "handler.type", COLUMN_I32, handlers, handler_type, NULL);
    add(d, "handler.message", COLUMN_I32, handlers, handler_message, "");
    add(d, "handler.place", COLUMN_I32, handlers, handler_place, NULL);
}

static void add_messages(struct traced *d)
{
    size_t n = (size_t)d->t->message_count, blocks = (size_t)d->t->block_count;
    add(d, "message.from", COLUMN_I32, n, message_from, NULL);
    add(d, "message.to", COLUMN_I32, n, message_to, NULL);
    add(d, "message.from_address", COLUMN_I32, n, message_from_address, "message.from");
    add(d, "message.to_address", COLUMN_I32, n, message_to_address, "message.to");
    add(d, "message.type", COLUMN_I32, n, message_type, NULL);
    add(d, "message.pid", COLUMN_I32, n, message_pid, NULL);
    add(d, "message.bytes", COLUMN_U64, n, message_bytes, NULL);
    add(d, "message.flags", COLUMN_U8, n, message_flags, NULL);
    add(d, "message.sent", COLUMN_U64, n, message_sent, "");
    add(d, "message.asked", COLUMN_U64, n, message_asked, "message.sent");
    add(d, "message.granted", COLUMN_U64, n, message_granted, "message.asked");
    add(d, "message.entered", COLUMN_U64, n, message_entered, "message.sent");
    add(d, "message.moved", COLUMN_U64, n, message_moved, "message.entered");
    add(d, "message.freed", COLUMN_U64, n, message_freed, "message.moved");
    add(d, "message.left", COLUMN_U64, n, message_left, "message.moved");
    add(d, "message.complete", COLUMN_U64, n, message_complete, "message.left");
    add(d, "message.taken", COLUMN_U64, n, message_taken, "message.complete");
    add(d, "message.sending", COLUMN_I32, n, message_sending, "");
    add(d, "message.taking", COLUMN_I32, n, message_taking, "");
    add(d, "block.begin", COLUMN_U64, blocks, block_begin, "");
    add(d, "block.end", COLUMN_U64, blocks, block_end, "block.begin");
    add(d, "block.message", COLUMN_I32, blocks, block_message, "");
    add(d, "block.channel", COLUMN_I32, blocks, block_channel, NULL);
}

/* --- the header ----------------------------------------------------------------------------------------- */

/* A time as text, for JSON's numbers may be rounded. */
static json_t *time_json(vtime t)
{
    char text[24];
    snprintf(text, sizeof text, "%" PRIu64, t);
    return json_string(text);
}

static json_t *topo_json(const struct topo *t)
{
    return json_pack("{s:i, s:i, s:i, s:i, s:i, s:i, s:b}", "nodes", (int)t->nodes, "dimension",
                     (int)t->dimension, "rows", (int)t->rows, "columns", (int)t->columns, "positions",
                     (int)t->positions, "addresses", (int)t->addresses, "host", t->host);
}

/* Finds the functions that computed in the pieces of a node, those from `first` on. */
static void find_worked(struct traced *d, size_t first)
{
    const size_t count = d->pieces.count - first;
    const struct trace_piece *list = &d->pieces.list[first];
    struct trace_around *around = xcalloc(count, sizeof *around);
    trace_around(d->t, list, count, around);
    d->worked = xreallocarray(d->worked, d->pieces.count, sizeof *d->worked);
    for (size_t i = 0; i < count; i++)
        d->worked[first + i] =
            list[i].state == TRACE_COMPUTING ? page_texts_worked(d->texts, &around[i]) : TRACE_NONE;
    free(around);
}

/* Fills in the pieces of all nodes, and the nodes' list: which pieces are whose. */
static json_t *nodes_json(struct traced *d)
{
    json_t *list = json_array();
    for (int32_t i = 0; i < d->t->node_count; i++) {
        const struct trace_node *n = &d->t->nodes[i];
        size_t first = d->pieces.count;
        const bool ran = trace_node_ran(d->t, i);
        if (n->traced && ran)
            trace_pieces(d->t, i, &d->pieces);
        if (d->pieces.count > first)
            find_worked(d, first);
        json_append(list,
                    json_pack("{s:o, s:I, s:b, s:b, s:I, s:I, s:i, s:i, s:o}", "name", json_text(n->name),
                              "address", (json_int_t)n->address, "traced", n->traced, "ran", ran, "first",
                              (json_int_t)first, "pieces", (json_int_t)(d->pieces.count - first),
                              "first_call", n->first_call, "calls", n->calls, "end", time_json(n->end)));
    }
    return list;
}

static json_t *names_json(const struct trace *t)
{
    json_t *list = json_array();
    for (int32_t i = 0; i < t->name_count; i++)
        json_append(list, json_text(t->names[i]));
    return list;
}

static json_t *optional(const char *text)
{
    return json_text(text ? text : "");
}

static json_t *header_json(struct traced *d)
{
    const struct trace *t = d->t;
    char digest[17];
    snprintf(digest, sizeof digest, "%016" PRIx64, t->digest);
    json_t *j = json_object();
    json_set(j, "program", optional(t->program));
    json_set(j, "machine", optional(t->machine));
    json_set(j, "command", optional(t->command));
    json_set(j, "from", time_json(t->from));
    json_set(j, "to", time_json(t->to));
    json_set(j, "end", time_json(t->end));
    json_set(j, "digest", json_string(digest));
    json_set(j, "complete", json_boolean(t->complete));
    json_set(j, "topology", topo_json(&t->topo));
    json_set(j, "nodes", nodes_json(d));
    json_set(j, "names", names_json(t));
    json_set(j, "texts", page_texts_json(d->texts));
    json_set(j, "channels", page_channels_json(&d->channels));
    json_set(j, "bins", json_integer(PAGE_CHANNEL_BINS));
    return j;
}

void page_trace_write(const struct trace *t, struct data_blob *b)
{
    struct traced d = {.t = t, .texts = page_texts_new(t)};
    page_channels_measure(&d.channels, t);
    json_t *header = header_json(&d);
    add_pieces(&d);
    add_calls(&d);
    add_messages(&d);
    d.count += page_channels_columns(&d.channels, &d.columns[d.count]);
    data_columns_write(b, header, d.columns, d.count);
    free(d.pieces.list);
    free(d.worked);
    page_channels_free(&d.channels);
    page_texts_free(d.texts);
}
