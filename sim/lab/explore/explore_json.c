/* explore_json.c - see explore_json.h. */
#include "lab/explore/explore_json.h"
#include <stdlib.h>
#include "files/json_set.h"
#include "files/json_write.h"
#include "kernel/xalloc.h"
#include "lab/explore/explore_report.h"
#include "lab/explore/guarantee.h"

static void set_count(json_t *o, const char *key, size_t count)
{
    json_set(o, key, json_integer((json_int_t)count));
}

static void set_text(json_t *o, const char *key, char *text)
{
    json_set(o, key, text ? json_text(text) : json_null());
    free(text);
}

static json_t *bounds_json(const struct draw *d)
{
    return xchecked(json_pack("{s:I, s:I, s:I, s:i}", "messages_ps", (json_int_t)d->messages, "interrupts_ps",
                              (json_int_t)d->interrupts, "start_ps", (json_int_t)d->start, "speed_ppm",
                              (int)d->speed_ppm));
}

static json_t *guarantee_json(const struct search *s)
{
    uint64_t events = (uint64_t)json_integer_value(json_object_get(s->outcomes[0].record, "events"));
    json_t *list = json_array();
    for (uint32_t depth = 1; depth <= s->draw.depth; depth++)
        json_append(list, xchecked(json_pack("{s:i, s:f, s:f}", "depth", (int)depth, "probability_of_a_run",
                                             guarantee_of_a_run(s->programs, events, depth), "runs_for_95",
                                             guarantee_runs(s->programs, events, depth))));
    return list;
}

static json_t *delays_json(const struct delays *d)
{
    json_t *list = json_array();
    for (size_t i = 0; i < d->count; i++)
        json_append(list,
                    xchecked(json_pack("{s:s, s:I, s:I, s:I}", "kind", delay_kind_name(d->list[i].kind),
                                       "node", (json_int_t)d->list[i].node, "index",
                                       (json_int_t)d->list[i].index, "value", (json_int_t)d->list[i].value)));
    return list;
}

static void set_explained(json_t *o, const struct explore *x, const struct explained *e)
{
    if (!e->name)
        return;
    set_text(o, "schedule", xasprintf("%s/%s.schedule", x->options.dir, e->name));
    json_set(o, "delays", delays_json(&e->least.delays));
    json_set(o, "delays_repeat", json_boolean(e->least.repeats));
    json_set(o, "delays_are_least", json_boolean(e->least.is_least));
    set_count(o, "tests", e->least.tests);
    set_text(o, "first_difference", e->first ? xstrdup(e->first) : NULL);
}

static json_t *outcome_json(const struct explore *x, size_t outcome)
{
    static const char *const copied[] = {"end", "group", "shown", "message", "stderr", "virtual_time_s"};
    const struct outcome_group *g = &x->search.outcomes[outcome];
    json_t *o = json_object();
    for (size_t i = 0; i < sizeof copied / sizeof *copied; i++)
        if (json_object_get(g->record, copied[i]))
            json_set(o, copied[i], json_incref(json_object_get(g->record, copied[i])));
    set_count(o, "runs", g->runs);
    set_count(o, "first_run", g->first);
    json_set(o, "first_name", json_string(x->search.runs[g->first].name));
    set_text(o, "repeat", explore_repeat(x, &x->search.runs[g->first]));
    set_explained(o, x, &x->explained[outcome]);
    return o;
}

static json_t *all_of(const struct explore *x)
{
    const struct search *s = &x->search;
    json_t *all = json_object(), *outcomes = json_array();
    for (size_t i = 0; i < s->outcome_count; i++)
        json_append(outcomes, outcome_json(x, i));
    json_set(all, "format", json_string("touchstone explore 1"));
    set_count(all, "runs", s->run_count);
    set_count(all, "orders", s->orders.count);
    set_count(all, "seeds", s->seeds);
    set_count(all, "directed", s->directed);
    set_count(all, "pruned", s->pruned);
    set_count(all, "beyond_bounds", s->out_of_bounds);
    set_count(all, "left", s->flip_count);
    set_count(all, "failed", s->failed);
    json_set(all, "times_differ", json_boolean(s->times_differ));
    json_set(all, "bounds", bounds_json(&x->options.draw));
    json_set(all, "guarantee", guarantee_json(s));
    json_set(all, "outcomes", outcomes);
    json_set(all, "wall_time_s", json_real(x->wall_s));
    set_count(all, "runs_made", x->made);
    return all;
}

bool explore_json(const struct explore *x, const char *path, char **error)
{
    return json_write(all_of(x), path, JSON_READABLE_DIGITS, error);
}
