/* study_estimate.c - estimates how long points take from earlier runs with other inputs; see
 * study_parts.h. */
#include "kernel/xalloc.h"
#include "lab/jobs/scratch_memory.h"
#include "lab/study/study_parts.h"

#include <stdlib.h>
#include <string.h>

/* A point's values, and how long its run took: a slot of a hash table with open addressing, at most half
 * full. */
struct time {
    struct digest values;
    double seconds; /* 0: this slot is free */
};

struct times {
    struct time *list;
    size_t capacity;
};

static struct time *time_of(const struct times *t, struct digest values)
{
    size_t i = values.low & (t->capacity - 1);
    while (t->list[i].seconds > 0 && !digest_equal(t->list[i].values, values))
        i = (i + 1) & (t->capacity - 1);
    return &t->list[i];
}

static void note(void *arg, struct digest key, const json_t *record)
{
    const json_t *values = json_object_get(record, "point");
    double seconds = json_number_value(json_object_get(record, "wall_time_s"));
    (void)key;
    if (!values || !(seconds > 0))
        return;
    struct digest d = digest_of_json(values);
    *time_of(arg, d) = (struct time){d, seconds};
}

static double known(const struct study *s, const struct times *t, const struct work *w)
{
    struct point p;
    char *error = NULL;
    double seconds = 0;
    if (point_make(s->spec, w->number, &p, &error) == POINT_WANTED) {
        json_t *values = point_values(s->spec, &p);
        seconds = time_of(t, digest_of_json(values))->seconds;
        json_decref(values);
    }
    free(error);
    return seconds;
}

static size_t with_result(const struct study *s)
{
    size_t count = 0;
    for (size_t i = 0; i < s->count; i++)
        count += journal_find(s->journal, s->work[i].key, NULL);
    return count;
}

/* Turns costs into seconds: known points have their time; the others' costs are scaled by the known points'
 * seconds per cost. */
static void take(struct study *s, const struct times *t)
{
    double seconds = 0, costs = 0;
    for (size_t i = 0; i < s->count; i++) {
        double took = known(s, t, &s->work[i]);
        seconds += took;
        costs += took > 0 ? s->work[i].cost : 0;
    }
    if (!(costs > 0))
        return;
    for (size_t i = 0; i < s->count; i++) {
        double took = known(s, t, &s->work[i]);
        s->work[i].cost = took > 0 ? took : s->work[i].cost * seconds / costs;
    }
}

void study_estimate(struct study *s)
{
    size_t have = with_result(s), others = journal_count(s->journal);
    if (have == s->count || others <= have)
        return;
    struct times t = {.capacity = 16};
    while (t.capacity < 2 * others)
        t.capacity *= 2;
    t.list = scratch_memory_new(t.capacity * sizeof *t.list);
    journal_each(s->journal, note, &t);
    take(s, &t);
    scratch_memory_free(t.list, t.capacity * sizeof *t.list);
}
