/* message_matrix.c - see message_matrix.h. */
#include "lab/show/message_matrix.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

/* The row of an end; the one behind the nodes' for others. */
static int32_t row_of(const struct node_rows *r, int32_t node)
{
    return node == TRACE_NONE || r->row[node] == TRACE_NONE ? r->count : r->row[node];
}

bool message_counts(const struct trace *t, const struct node_rows *r, const struct trace_message *m)
{
    return m->sent >= t->from && m->sent <= t->to &&
           (row_of(r, m->from) < r->count || row_of(r, m->to) < r->count);
}

static bool has_others(const struct trace *t, const struct node_rows *r)
{
    for (const struct trace_message *m = t->messages; m < t->messages + t->message_count; m++)
        if (message_counts(t, r, m) && (row_of(r, m->from) == r->count || row_of(r, m->to) == r->count))
            return true;
    return false;
}

struct message_matrix message_matrix_make(const struct trace *t, const struct node_rows *r)
{
    struct message_matrix x = {.others = has_others(t, r)};
    x.size = r->count + x.others;
    x.cells = xcalloc((size_t)x.size * (size_t)x.size, sizeof *x.cells);
    for (const struct trace_message *m = t->messages; m < t->messages + t->message_count; m++) {
        if (!message_counts(t, r, m))
            continue;
        struct message_sum *cell = message_matrix_at(&x, row_of(r, m->from), row_of(r, m->to));
        cell->messages++, x.messages++;
        cell->bytes += m->bytes, x.bytes += m->bytes;
    }
    return x;
}

void message_matrix_free(struct message_matrix *m)
{
    free(m->cells);
}
