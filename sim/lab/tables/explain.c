/* explain.c - see explain.h. Reading and checking; showing is in explain_print.c. */
#include "lab/tables/explain.h"
#include "kernel/xalloc.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const CLASSES[EXPLAIN_CLASSES] = {"hosts", "slaves"};

/* --- lines ----------------------------------------------------------------------------------------------- */

/* The line of that label, a new one at the end if there is none. Takes the label. */
static struct explain_line *line(struct explain_part *part, char *label)
{
    for (size_t i = 0; i < part->count; i++)
        if (strcmp(part->lines[i].label, label) == 0) {
            free(label);
            return &part->lines[i];
        }
    part->lines = xrealloc(part->lines, (part->count + 1) * sizeof *part->lines);
    part->lines[part->count] = (struct explain_line){.label = label};
    return &part->lines[part->count++];
}

double explain_sum(const struct explain_part *part, enum explain_class c)
{
    double sum = 0;
    for (size_t i = 0; i < part->count; i++)
        sum += part->lines[i].s[c];
    return sum;
}

/* --- what the program says --------------------------------------------------------------------------------- */

static double of_class(const struct outcome *o, int c, const char *what)
{
    char *key = xasprintf("times_%s_%s", CLASSES[c], what);
    double value = outcome_figure(o, key);
    free(key);
    return value;
}

static void read_activities(struct explain *e, const struct outcome *o)
{
    static const char *const ACTIVITIES[][2] = {
        {"reading_s", "reading slices"},
        {"helping_s", "helping"},
        {"computing_s", "computing chunks"},
        {"answering_s", "handlers: requests"},
        {"packing_s", "handlers: packing chunks"},
        {"collecting_s", "handlers: polygons"},
        {"news_s", "handlers: other"},
        {"sending_s", "sending requests, polygons"},
        {"wait_requests_s", "waiting for requests"},
        {"wait_slaves_s", "waiting for last polygons"},
        {"wait_chunk_s", "waiting for a chunk"},
        {"wait_order_s", "waiting for an order"},
        {"dealing_s", "telling hosts, dealing nodes"},
        {"other_s", "the rest"},
    };
    for (size_t i = 0; i < sizeof ACTIVITIES / sizeof *ACTIVITIES; i++)
        for (int c = 0; c < EXPLAIN_CLASSES; c++)
            line(&e->program, xstrdup(ACTIVITIES[i][1]))->s[c] = of_class(o, c, ACTIVITIES[i][0]);
}

static int by_layer(const void *a, const void *b)
{
    return ((const struct explain_layer *)a)->layer - ((const struct explain_layer *)b)->layer;
}

static void read_layers(struct explain *e, const struct outcome *o)
{
    const char *key;
    json_t *value;
    e->layers = xcalloc(json_object_size(o->printed) + 1, sizeof *e->layers);
    json_object_foreach(o->printed, key, value)
    {
        struct explain_layer l;
        if (sscanf(key, "times_layer_%d", &l.layer) != 1 ||
            json_array_size(value) != 1 + EXPLAIN_LAYER_FIGURES)
            continue;
        l.host = (int)json_number_value(json_array_get(value, 0));
        for (size_t i = 0; i < EXPLAIN_LAYER_FIGURES; i++)
            l.s[i] = json_number_value(json_array_get(value, i + 1));
        e->layers[e->layer_count++] = l;
    }
    qsort(e->layers, e->layer_count, sizeof *e->layers, by_layer);
}

/* --- what the simulator says ------------------------------------------------------------------------------- */

static double number(json_t *object, const char *key)
{
    return json_number_value(json_object_get(object, key));
}

/* "idle: crecv, wake", "idle: read" */
static char *wait_label(const struct paper *p, json_t *wait)
{
    const char *call = json_string_value(json_object_get(wait, "call"));
    json_t *type = json_object_get(wait, "type");
    const char *name = type ? paper_message_name(p, (long)json_integer_value(type)) : NULL;
    if (name)
        return xasprintf("idle: %s, %s", call, name);
    if (type)
        return xasprintf("idle: %s, type %lld", call, (long long)json_integer_value(type));
    return xasprintf("idle: %s", call);
}

static void add_tasks(struct explain *e, int c, json_t *node)
{
    static const char *const TASKS[][2] = {
        {"calls_s", "system: calls"},
        {"sending_s", "system: sending"},
        {"receiving_s", "system: receiving"},
        {"copying_s", "system: copying"},
        {"interrupts_s", "system: interrupts"},
        {"feeding_s", "system: feeding channels"},
        {"emptying_s", "system: emptying channels"},
    };
    json_t *tasks = json_object_get(node, "tasks");
    for (size_t i = 0; i < sizeof TASKS / sizeof *TASKS; i++)
        line(&e->processor, xstrdup(TASKS[i][1]))->s[c] += number(tasks, TASKS[i][0]);
    line(&e->processor, xstrdup("less system beside it"))->s[c] -= number(node, "beside_s");
}

/* False if the node's figures do not add up to the time at which it ended. */
static bool add_node(struct explain *e, const struct paper *p, int c, json_t *node, double *ended_s)
{
    json_t *wait;
    size_t i;
    double sum = number(node, "busy_s");
    line(&e->processor, xstrdup("computing"))->s[c] += number(node, "busy_s");
    add_tasks(e, c, node);
    json_array_foreach(json_object_get(node, "waits"), i, wait)
    {
        line(&e->processor, wait_label(p, wait))->s[c] += number(wait, "idle_s");
        sum += number(wait, "idle_s");
    }
    sum += number(node, "system_s");
    *ended_s += number(node, "ended_s");
    return fabs(sum - number(node, "ended_s")) < 1e-6;
}

/* --- the whole --------------------------------------------------------------------------------------------- */

static bool same(double a, double b, double most)
{
    return fabs(a - b) <= most * fmax(fabs(a), fabs(b)) + 1e-6;
}

/* *error set, unless both accounts cover nodes x total: the program's up to the moment when the last order has come. */
static char *check(const struct explain *e, int c, double ran_s, double ended_s)
{
    double program = explain_sum(&e->program, c), processor = explain_sum(&e->processor, c);
    if (!same(program, ran_s, 1e-6))
        return xasprintf("the %s' activities add up to %.6f s, not %.6f", CLASSES[c], program, ran_s);
    if (!same(ran_s, e->nodes[c] * e->total_s, 1e-3))
        return xasprintf("the %s ran for %.6f s, but %u times the total time is %.6f s", CLASSES[c], ran_s,
                         e->nodes[c], e->nodes[c] * e->total_s);
    if (!same(processor, ended_s, 1e-6))
        return xasprintf("the %s' processors account for %.6f s, not %.6f", CLASSES[c], processor, ended_s);
    return NULL;
}

static char *read_all(struct explain *e, const struct paper *p, const struct outcome *o)
{
    json_t *node;
    size_t i;
    double ended_s[EXPLAIN_CLASSES] = {0};
    read_activities(e, o);
    read_layers(e, o);
    json_array_foreach(json_object_get(o->run, "node"), i, node)
    {
        int c = i % e->row->group ? EXPLAIN_SLAVES : EXPLAIN_HOSTS;
        e->nodes[c]++;
        if (!add_node(e, p, c, node, &ended_s[c]))
            return xasprintf("the figures of node %zu do not add up to its time", i);
    }
    for (int c = 0; c < EXPLAIN_CLASSES; c++) {
        double ran_s = of_class(o, c, "ended_s") - of_class(o, c, "began_s");
        if (isnan(ran_s))
            return xasprintf("the program printed no times_%s_...", CLASSES[c]);
        char *error = check(e, c, ran_s, ended_s[c]);
        if (error)
            return error;
        e->around_s[c] = ended_s[c] - ran_s;
    }
    return NULL;
}

struct explain *explain_read(const struct paper *p, const struct paper_row *row, unsigned table,
                             const struct outcome *timed, const struct outcome *plain, char **error)
{
    const struct outcome *failed = timed->error ? timed : plain;
    if (failed->error) {
        *error = xstrdup(failed->error);
        return NULL;
    }
    struct explain *e = xcalloc(1, sizeof *e);
    e->row = row;
    e->table = table;
    e->total_s = outcome_figure(timed, "total_s");
    e->plain_s = outcome_figure(plain, "total_s");
    *error = read_all(e, p, timed);
    if (!*error)
        return e;
    explain_free(e);
    return NULL;
}

static void free_part(struct explain_part *part)
{
    for (size_t i = 0; i < part->count; i++)
        free(part->lines[i].label);
    free(part->lines);
}

void explain_free(struct explain *e)
{
    if (!e)
        return;
    free_part(&e->program);
    free_part(&e->processor);
    free(e->layers);
    free(e);
}
