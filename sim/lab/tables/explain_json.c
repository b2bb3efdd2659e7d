/* explain_json.c - see explain_json.h. */
#include "lab/tables/explain_json.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"

/* Seconds of the nodes of each class; null: the run has none of that class. */
static void set_classes(json_t *o, const struct explain *e, const double s[EXPLAIN_CLASSES])
{
    static const char *const KEYS[EXPLAIN_CLASSES] = {"hosts_s", "slaves_s"};
    for (int c = 0; c < EXPLAIN_CLASSES; c++)
        json_set(o, KEYS[c], e->nodes[c] ? json_real(s[c]) : json_null());
}

static json_t *part_json(const struct explain *e, const struct explain_part *part)
{
    json_t *list = xchecked(json_array());
    for (size_t i = 0; i < part->count; i++) {
        json_t *o = xchecked(json_pack("{s:o}", "what", json_text(part->lines[i].label)));
        set_classes(o, e, part->lines[i].s);
        json_append(list, o);
    }
    return list;
}

static json_t *layers_json(const struct explain *e)
{
    static const char *const KEYS[EXPLAIN_LAYER_FIGURES] = {
        "from_s", "for_s", "reading_s", "helping_s", "serving_s", "packing_s", "waiting_s"};
    json_t *list = xchecked(json_array());
    for (size_t i = 0; i < e->layer_count; i++) {
        const struct explain_layer *l = &e->layers[i];
        json_t *o = xchecked(json_pack("{s:i, s:i}", "layer", l->layer, "host", l->host));
        for (size_t k = 0; k < EXPLAIN_LAYER_FIGURES; k++)
            json_set(o, KEYS[k], json_real(l->s[k]));
        json_append(list, o);
    }
    return list;
}

json_t *explain_json(const struct explain *e)
{
    json_t *around = xchecked(json_object());
    set_classes(around, e, e->around_s);
    return xchecked(json_pack(
        "{s:s, s:i, s:i, s:i, s:i, s:f, s:f, s:f, s:o, s:o, s:o, s:o}", "format", "touchstone explain 1",
        "table", (int)e->table, "nodes", (int)e->row->nodes, "hosts", (int)e->nodes[EXPLAIN_HOSTS], "slaves",
        (int)e->nodes[EXPLAIN_SLAVES], "total_s", e->plain_s, "measured_total_s", e->total_s, "paper_total_s",
        e->row->paper.total_s, "program", part_json(e, &e->program), "processors",
        part_json(e, &e->processor), "start_and_end", around, "layers", layers_json(e)));
}
