/* why_json.c - see why_json.h. */
#include "lab/why/why_json.h"
#include "files/json_set.h"
#include "lab/why/path_shares.h"
#include "lab/why/why_sentences.h"

static json_t *sentences(struct why *w)
{
    char **paragraphs = why_sentences(w);
    json_t *array = json_texts(paragraphs);
    why_sentences_free(paragraphs);
    return array;
}

/* --- the path --- */

static json_t *classes(const struct why *w)
{
    json_t *list = json_array();
    for (int i = 0; i < WHY_CLASSES; i++) {
        json_t *row = json_object();
        json_set(row, "class", json_text(why_class_key((enum why_class)i)));
        json_set(row, "time_ps", json_ps(w->by_class[i]));
        json_set(row, "at_least_without_ps", json_ps(w->length - w->by_class[i]));
        json_append(list, row);
    }
    return list;
}

static json_t *share(const struct tally *t)
{
    json_t *list = json_array();
    for (size_t i = 0; i < t->count; i++) {
        json_t *row = json_object();
        json_set(row, "what", json_text(t->rows[i].label));
        json_set(row, "time_ps", json_ps(t->rows[i].time));
        json_set(row, "steps", json_integer((json_int_t)t->rows[i].count));
        json_append(list, row);
    }
    return list;
}

/* Indexes of the trace's tables that the step has. */
static json_t *step(struct why *w, const struct path_step *s)
{
    json_t *row = json_object();
    json_set(row, "begin_ps", json_ps(s->begin));
    json_set(row, "end_ps", json_ps(s->end));
    json_set(row, "class", json_text(why_class_key(s->class)));
    if (s->node != TRACE_NONE)
        json_set(row, "node", json_integer(s->node));
    if (s->call != TRACE_NONE)
        json_set(row, "call", json_integer(s->call));
    if (s->handler != TRACE_NONE)
        json_set(row, "handler", json_integer(s->handler));
    if (s->message != TRACE_NONE)
        json_set(row, "message", json_integer(s->message));
    if (s->block != TRACE_NONE && w->holder[s->block] != TRACE_NONE)
        json_set(row, "held_by_message", json_integer(w->holder[s->block]));
    if (*places_line(w->places, s->stack))
        json_set(row, "place", json_text(places_line(w->places, s->stack)));
    return row;
}

static json_t *path(struct why *w, bool with_path)
{
    json_t *o = json_object(), *steps = json_array();
    json_set(o, "length_ps", json_ps(w->length));
    json_set(o, "jumps", json_integer((json_int_t)w->path.jumps));
    json_set(o, "by_class", classes(w));
    json_set(o, "entering_handlers_ps", json_ps(w->entering));
    for (int s = 0; s < WHY_SHARES; s++)
        json_set(o, why_share_key((enum why_share)s), share(&w->shares[s]));
    for (size_t i = 0; i < w->path.count && with_path; i++)
        json_append(steps, step(w, &w->path.steps[i]));
    json_set(o, "step_count", json_integer((json_int_t)w->path.count));
    if (with_path)
        json_set(o, "steps", steps);
    else
        json_decref(steps);
    return o;
}

/* --- waits --- */

static json_t *longest(const struct why *w, const struct wait_group *g)
{
    json_t *o = json_object();
    json_set(o, "wait", json_integer(g->longest));
    json_set(o, "node", json_text(why_node_name(w, w->t->waits[g->longest].node)));
    json_set(o, "begin_ps", json_ps(w->t->waits[g->longest].begin));
    json_set(o, "idle_ps", json_ps(g->longest_idle));
    return o;
}

static json_t *group(const struct why *w, const struct wait_group *g)
{
    json_t *row = json_object();
    json_set(row, "cause", json_text(wait_cause_key(g->cause)));
    if (g->cause == WAIT_LATE_SENDER || g->cause == WAIT_LATE_RECEIVER)
        json_set(row, "partner_was", json_text(trace_state_name(g->doing)));
    json_set(row, "idle_ps", json_ps(g->idle));
    json_set(row, "waits", json_integer((json_int_t)g->waits));
    json_set(row, "nodes", json_integer(g->nodes));
    json_set(row, "in", json_text(g->call));
    json_set(row, "sent_by", json_text(g->sent));
    json_set(row, "until_left", json_boolean(g->leaves));
    if (g->partner != TRACE_NONE && !g->partners)
        json_set(row, "partner", json_text(why_node_name(w, g->partner)));
    json_set(row, "several_partners", json_boolean(g->partners));
    if (g->has_type)
        json_set(row, "types", json_pack("[i,i]", (int)g->type, (int)g->last_type));
    json_set(row, "longest", longest(w, g));
    return row;
}

static json_t *waits(const struct why *w)
{
    json_t *o = json_object(), *causes = json_object(), *list = json_array();
    json_set(o, "idle_ps", json_ps(w->causes.idle));
    for (int i = 0; i < WAIT_CAUSES; i++)
        json_set(causes, wait_cause_key((enum wait_cause)i), json_ps(w->causes.by_cause[i]));
    json_set(o, "by_cause_ps", causes);
    for (size_t i = 0; i < w->group_count; i++)
        json_append(list, group(w, &w->groups[i]));
    json_set(o, "groups", list);
    return o;
}

/* --- other runs --- */

static json_t *show_reruns(const struct reruns *r)
{
    json_t *list = json_array();
    for (size_t i = 0; i < r->count; i++) {
        const struct rerun *x = &r->list[i];
        json_t *row = json_object();
        json_set(row, "change", json_text(x->key));
        json_set(row, "what", json_text(x->what));
        json_set(row, "settings", json_texts(x->set));
        if (x->done)
            json_set(row, "end_ps", json_ps(x->end));
        else
            json_set(row, "error", json_text(x->error));
        json_append(list, row);
    }
    return list;
}

static json_t *compared(struct why *than)
{
    json_t *o = json_object();
    json_set(o, "trace", json_text(than->t->path));
    json_set(o, "nodes", json_integer(trace_nodes_ran(than->t)));
    json_set(o, "path", path(than, false));
    return o;
}

json_t *why_json(struct why *w, const struct why_report_options *o, bool with_path)
{
    const struct trace *t = w->t;
    json_t *root = json_object();
    json_set(root, "format", json_text("touchstone why 2"));
    json_set(root, "trace", json_text(t->path));
    json_set(root, "program", json_text(t->program));
    json_set(root, "machine", json_text(t->machine));
    json_set(root, "nodes", json_integer(trace_nodes_ran(t)));
    json_set(root, "from_ps", json_ps(t->from));
    json_set(root, "to_ps", json_ps(t->to));
    json_set(root, "end_ps", json_ps(t->end));
    json_set(root, "sentences", sentences(w));
    json_set(root, "critical_path", path(w, with_path));
    json_set(root, "waits", waits(w));
    if (o->than)
        json_set(root, "than", compared(o->than));
    if (o->reruns)
        json_set(root, "reruns", show_reruns(o->reruns));
    return root;
}
