/* point_figures.c - see point_figures.h. */
#include "lab/study/point_figures.h"
#include "files/json_set.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MAX_KEY = 128,
    GLOBAL_TYPES = 1000000000 /* types from here on are the system's own: nx.h */
};

static void set_first(json_t *to, const char *key, json_t *value)
{
    if (!json_object_get(to, key))
        json_set(to, key, json_incref(value));
}

/* Adds value to the number PREFIX.KEY, which starts at 0. */
static void sum(json_t *to, const char *prefix, const char *key, double value)
{
    char name[2 * MAX_KEY];
    snprintf(name, sizeof name, "%s.%s", prefix, key);
    double before = json_number_value(json_object_get(to, name));
    json_set(to, name, json_real(before + value));
}

static void sum_waits(json_t *to, const char *prefix, json_t *waits, double share)
{
    size_t i;
    json_t *wait;
    json_array_foreach(waits, i, wait)
    {
        char key[MAX_KEY];
        json_t *type = json_object_get(wait, "type");
        const char *call = !type ? json_string_value(json_object_get(wait, "call"))
                           : json_integer_value(type) >= GLOBAL_TYPES ? "global"
                                                                      : "message";
        snprintf(key, sizeof key, "waits.%s_s", call ? call : "other");
        sum(to, prefix, key, share * json_number_value(json_object_get(wait, "idle_s")));
    }
}

static bool has_handlers(json_t *node)
{
    return json_integer_value(json_object_get(node, "handlers")) > 0;
}

/* Adds the means over the nodes of one class. */
static void add_class(json_t *to, json_t *nodes, const char *prefix, bool handlers)
{
    static const char *const keys[] = {"busy_s", "idle_s", "system_s"};
    size_t i, count = 0;
    json_t *node;
    json_array_foreach(nodes, i, node) count += has_handlers(node) == handlers;
    json_array_foreach(nodes, i, node)
    {
        if (has_handlers(node) != handlers)
            continue;
        sum(to, prefix, "nodes", 1);
        for (size_t k = 0; k < sizeof keys / sizeof *keys; k++)
            sum(to, prefix, keys[k], json_number_value(json_object_get(node, keys[k])) / (double)count);
        sum_waits(to, prefix, json_object_get(node, "waits"), 1 / (double)count);
    }
}

static void add_run(json_t *to, json_t *run)
{
    const char *key, *inner;
    json_t *value, *member;
    json_object_foreach(run, key, value)
    {
        if (strcmp(key, "node") == 0 || strcmp(key, "format") == 0)
            continue;
        if (!json_is_object(value))
            set_first(to, key, value);
        else
            json_object_foreach(value, inner, member)
            {
                char name[MAX_KEY];
                snprintf(name, sizeof name, "%s.%s", key, inner);
                set_first(to, name, member);
            }
    }
}

/* Adds idle_pct: idle time as a part of all nodes' time until the last node's end. */
static void add_idle(json_t *to, json_t *run, json_t *nodes)
{
    size_t i;
    json_t *node;
    double idle = 0,
           all = json_number_value(json_object_get(run, "virtual_time_s")) * (double)json_array_size(nodes);
    json_array_foreach(nodes, i, node) idle += json_number_value(json_object_get(node, "idle_s"));
    json_t *percent = json_real(all > 0 ? 100 * idle / all : 0);
    set_first(to, "idle_pct", percent);
    json_decref(percent);
}

/* Adds the largest memory use of any node. */
static void add_memory(json_t *to, json_t *nodes)
{
    size_t i;
    json_t *node;
    json_int_t most = 0;
    json_array_foreach(nodes, i, node)
    {
        json_int_t peak = json_integer_value(json_object_get(node, "memory_peak_bytes"));
        most = peak > most ? peak : most;
    }
    json_t *bytes = json_integer(most);
    set_first(to, "memory_peak_bytes", bytes);
    json_decref(bytes);
}

json_t *point_figures_of(const struct outcome *o)
{
    json_t *figures = json_copy(o->printed), *nodes = json_object_get(o->run, "node");
    add_run(figures, o->run);
    add_idle(figures, o->run, nodes);
    add_memory(figures, nodes);
    add_class(figures, nodes, "handlers", true);
    add_class(figures, nodes, "others", false);
    return figures;
}
