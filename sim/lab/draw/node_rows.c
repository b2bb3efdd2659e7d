/* node_rows.c - see node_rows.h. */
#include "lab/draw/node_rows.h"
#include <stdlib.h>
#include "kernel/xalloc.h"

static bool is_host(const struct trace *t, int32_t node)
{
    return topo_is_host(&t->topo, t->nodes[node].address);
}

/* Puts a node into the last row, or into a new one. */
static void add(struct node_rows *r, const struct trace *t, int32_t node, bool apart)
{
    struct node_class *last = r->count ? &r->classes[r->count - 1] : NULL;
    bool host = is_host(t, node);
    if (!last || host || apart || last->apart || r->nodes % r->per == 0) {
        last = &r->classes[r->count++];
        *last = (struct node_class){.first = node, .apart = apart};
        r->apart += apart;
    }
    last->last = node;
    last->size++;
    r->host |= host;
    r->row[node] = r->count - 1;
    r->nodes++;
}

/* apart: of each node, whether it has a row of its own; NULL: none. */
static struct node_rows rows_of(const struct trace *t, int32_t per, const bool *apart)
{
    size_t room = (size_t)t->node_count;
    struct node_rows r = {.per = per};
    r.row = xcalloc(room, sizeof *r.row);
    r.classes = xcalloc(room, sizeof *r.classes);
    for (int32_t n = 0; n < t->node_count; n++) {
        r.row[n] = TRACE_NONE;
        if (t->nodes[n].traced && trace_node_ran(t, n))
            add(&r, t, n, apart && apart[n]);
    }
    return r;
}

/* How many messages a row's nodes sent and received. malloc'd. */
static double *messages_of(const struct node_rows *r, const struct trace *t)
{
    double *counts = xcalloc((size_t)r->count, sizeof *counts);
    for (const struct trace_message *m = t->messages; m < t->messages + t->message_count; m++) {
        const int32_t ends[] = {m->from, m->to};
        for (int i = 0; i < 2; i++)
            if (ends[i] != TRACE_NONE && r->row[ends[i]] != TRACE_NONE)
                counts[r->row[ends[i]]]++;
    }
    return counts;
}

/* Which rows are hosts' (node_rows_heighten()). malloc'd; *count: how many. */
static bool *find_hosts(const struct node_rows *r, const struct trace *t, int32_t *count)
{
    bool *hosts = xcalloc((size_t)r->count, sizeof *hosts);
    double *messages = messages_of(r, t), sum = 0;
    for (int32_t i = 0; i < r->count; i++)
        sum += messages[i];
    *count = 0;
    for (int32_t i = 0; i < r->count; i++) {
        hosts[i] = is_host(t, r->classes[i].first) ||
                   (r->per == 1 ? messages[i] > 2 * sum / r->count : r->classes[i].apart);
        *count += hosts[i];
    }
    free(messages);
    return hosts;
}

struct node_rows node_rows_single(const struct trace *t)
{
    return rows_of(t, 1, NULL);
}

/* Which nodes have a row of their own among many that share one: hosts, if they are few. malloc'd. */
static bool *find_apart(const struct node_rows *single, const struct trace *t)
{
    int32_t count;
    bool *hosts = find_hosts(single, t, &count), *apart = xcalloc((size_t)t->node_count, sizeof *apart);
    for (int32_t i = 0; i < single->count && count <= NODE_ROWS_APART; i++)
        apart[single->classes[i].first] = hosts[i] && !is_host(t, single->classes[i].first);
    free(hosts);
    return apart;
}

struct node_rows node_rows_make(const struct trace *t)
{
    struct node_rows single = rows_of(t, 1, NULL);
    int32_t nodes = single.nodes - single.host, per = 2;
    if (nodes <= NODE_ROWS_SINGLE)
        return single;
    while ((nodes + per - 1) / per > NODE_ROWS_CLASSES)
        per *= 2;
    bool *apart = find_apart(&single, t);
    struct node_rows r = rows_of(t, per, apart);
    free(apart);
    node_rows_free(&single);
    return r;
}

double node_rows_heighten(struct node_rows *r, const struct trace *t, double times)
{
    int32_t count;
    bool *hosts = find_hosts(r, t, &count);
    double all = r->count + count * (times - 1), sum = 0;
    if (count > 0 && count <= r->count / 4) {
        r->edge = xcalloc((size_t)r->count + 1, sizeof *r->edge);
        for (int32_t i = 0; i < r->count; i++)
            r->edge[i + 1] = (sum += hosts[i] ? times : 1) / all;
    }
    free(hosts);
    return r->edge ? all : r->count;
}

void node_rows_free(struct node_rows *r)
{
    free(r->edge);
    free(r->row);
    free(r->classes);
}

char *node_rows_label(const struct node_rows *r, const struct trace *t, int32_t row)
{
    const struct node_class *c = &r->classes[row];
    const bool wide = r->classes[r->count - 1].last >= 10000;
    if (is_host(t, c->first))
        return xstrdup("host");
    return c->size == 1 ? xasprintf("%d", c->first)
           : wide       ? xasprintf("%d\u2026", c->first)
                        : xasprintf("%d\u2013%d", c->first, c->last);
}

char *node_rows_text(const struct node_rows *r, const char *what)
{
    int32_t nodes = r->nodes - r->host;
    char *text = nodes == 0  ? xstrdup("the host")
                 : nodes > 1 ? xasprintf("%d nodes%s", nodes, r->host ? " and the host" : "")
                             : xasprintf("1 node%s", r->host ? " and the host" : "");
    if (r->per == 1)
        return text;
    char *all = xasprintf("%s in %d %s of %d%s", text, r->count - r->host - r->apart, what, r->per,
                          r->apart ? ", those that serve the others apart" : "");
    free(text);
    return all;
}
