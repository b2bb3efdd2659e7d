/* search.c - see search.h. */
#include "lab/explore/search.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/xalloc.h"
#include "lab/explore/race_flips.h"
#include "timing/draw_read.h"

enum { FIRST_ROUND = 4, USUAL_ROUND = 16, LARGEST_ROUND = 256, ROUNDS_OF_A_SIZE = 4, MOST_TRIES = 2 };
enum { MOST_FLIPS = 1 << 18, MOST_CLOCKS = 1 << 26, MARGIN = 2 * VT_MICROSECOND };

struct place_count {
    uint64_t place;
    size_t tries;
};

struct delay_bounds search_bounds(const struct search *s)
{
    return (struct delay_bounds){{[DELAY_SPEED] = s->draw.speed_ppm,
                                  [DELAY_START] = (int64_t)s->draw.start,
                                  [DELAY_MESSAGE] = (int64_t)s->draw.messages,
                                  [DELAY_INTERRUPT] = (int64_t)s->draw.interrupts}};
}

/* --- seeds ---------------------------------------------------------------------------------------------- */

static uint64_t length_of_base(const struct search *s)
{
    json_int_t events = json_integer_value(json_object_get(s->outcomes[0].record, "events"));
    return events > 0 ? (uint64_t)events : s->draw.length;
}

/* Odd seeds are drawn at random, even ones in the manner of PCT. */
static struct planned_run of_seed(struct search *s)
{
    struct draw d = s->draw;
    d.seed = ++s->seeds;
    d.method = d.seed % 2 ? DRAW_RANDOM : DRAW_PCT;
    if (d.method == DRAW_PCT) {
        d.depth = (uint32_t)((d.seed / 2 - 1) % s->draw.depth) + 1;
        d.length = length_of_base(s);
    }
    char *name = d.method == DRAW_PCT
                     ? xasprintf("seed %" PRIu64 " (pct, depth %" PRIu32 ")", d.seed, d.depth)
                     : xasprintf("seed %" PRIu64 " (random)", d.seed);
    return planned_run(s->place->subject, name, draw_text(&d), NULL);
}

/* --- directed ------------------------------------------------------------------------------------------- */

static struct place_count *count_of(struct search *s, uint64_t place)
{
    for (size_t i = 0; i < s->place_count; i++)
        if (s->places[i].place == place)
            return &s->places[i];
    s->places = xreallocarray(s->places, s->place_count + 1, sizeof *s->places);
    s->places[s->place_count] = (struct place_count){.place = place};
    return &s->places[s->place_count++];
}

/* Drops flips whose order a run has had, and those that have been tried often enough. */
static void drop_flips(struct search *s)
{
    size_t kept = 0;
    for (size_t i = 0; i < s->flip_count; i++) {
        const struct flip_of_run *f = &s->flips[i];
        bool had = digest_set_has(&s->events, f->flip.order);
        s->pruned += had && !f->tries;
        if (!had && f->tries < (f->flip.handler ? 1 : MOST_TRIES))
            s->flips[kept++] = *f;
    }
    s->flip_count = kept;
}

/* The flip whose place was tried least; of these the first. In a round each flip is tried once. */
static struct flip_of_run *next_flip(struct search *s, const bool *used)
{
    struct flip_of_run *best = NULL;
    size_t least = SIZE_MAX;
    for (size_t i = 0; i < s->flip_count; i++) {
        size_t tries = used[i] ? SIZE_MAX : count_of(s, s->flips[i].flip.place)->tries + s->flips[i].tries;
        if (tries < least)
            least = tries, best = &s->flips[i];
    }
    return best;
}

/* The first try adds little, the second more: the delay may change other delays on the way. */
static int64_t margin_of(const struct flip_of_run *f)
{
    return f->tries ? (int64_t)(25 * MARGIN) + f->flip.later / 2 : (int64_t)MARGIN;
}

/* The schedule that should bring the flip about; NULL: the bounds do not allow it. */
static char *schedule_of(const struct search *s, const struct flip_of_run *f)
{
    char *error = NULL, *path = batch_recording(s->place, s->runs[f->run].key), *text = NULL;
    struct recording *r = recording_load(path, &error);
    struct delay_bounds bounds = search_bounds(s);
    if (r && flip_delay(&f->flip, margin_of(f), &bounds, &r->delays))
        text = delays_text(&r->delays, r->nodes, "");
    recording_free(r);
    free(error);
    free(path);
    return text;
}

/* Plans a directed run. Returns how many: 0 if an equal one was planned before. */
static size_t plan_one(struct search *s, char *schedule, struct planned_run *run)
{
    *run = planned_run(s->place->subject, xasprintf("directed %zu", s->directed + 1), NULL, schedule);
    if (digest_set_add(&s->keys, run->key)) {
        s->directed++;
        return 1;
    }
    planned_run_free(run);
    return 0;
}

/* Plans up to `most` directed runs. Returns how many. */
static size_t plan_directed(struct search *s, struct planned_run *runs, size_t most)
{
    size_t count = 0;
    drop_flips(s);
    bool *used = xcalloc(s->flip_count + 1, sizeof *used);
    for (struct flip_of_run *f; count < most && (f = next_flip(s, used));) {
        char *schedule = schedule_of(s, f);
        used[f - s->flips] = true;
        if (schedule)
            count += plan_one(s, schedule, &runs[count]);
        else
            s->out_of_bounds++;
        count_of(s, f->flip.place)->tries += schedule != NULL;
        f->tries = schedule ? f->tries + 1 : MOST_TRIES;
    }
    free(used);
    return count;
}

/* --- rounds --------------------------------------------------------------------------------------------- */

static size_t size_of_round(const struct search *s)
{
    if (s->round < 2)
        return s->round ? FIRST_ROUND : 1;
    size_t doubled = (s->round - 2) / ROUNDS_OF_A_SIZE, size = USUAL_ROUND;
    while (doubled-- && size < LARGEST_ROUND)
        size *= 2;
    return size;
}

size_t search_round(struct search *s, struct planned_run **runs)
{
    size_t size = size_of_round(s), left = s->most - s->planned, count = 0;
    size = size < left ? size : left;
    *runs = xcalloc(size + 1, sizeof **runs);
    if (!s->round)
        (*runs)[count++] = planned_run(s->place->subject, xstrdup("the usual timing"), NULL, NULL);
    else if (s->round > 1)
        count = plan_directed(s, *runs, (size + 1) / 2);
    while (count < size)
        (*runs)[count++] = of_seed(s);
    s->planned += count;
    s->round++;
    return count;
}

/* --- results -------------------------------------------------------------------------------------------- */

static size_t outcome_of(struct search *s, const struct planned_run *r)
{
    const char *group = json_string_value(json_object_get(r->record, "group"));
    for (size_t i = 0; i < s->outcome_count; i++)
        if (!strcmp(s->outcomes[i].group, group))
            return i;
    s->outcomes = xreallocarray(s->outcomes, s->outcome_count + 1, sizeof *s->outcomes);
    struct outcome_group *g = &s->outcomes[s->outcome_count];
    *g = (struct outcome_group){
        .record = json_incref(r->record), .first = s->run_count, .least = s->run_count};
    snprintf(g->group, sizeof g->group, "%s", group);
    return s->outcome_count++;
}

static void add_flips(struct search *s, const struct order *o, const struct clocks *c, const json_t *record,
                      size_t run)
{
    struct delay_bounds bounds = search_bounds(s);
    struct flips found = flips_of(o, c, &bounds);
    race_flips_add(&found, o, &bounds, json_object_get(record, "races"));
    s->flips = xreallocarray(s->flips, s->flip_count + found.count + 1, sizeof *s->flips);
    for (size_t i = 0; i < found.count && s->flip_count < MOST_FLIPS; i++)
        if (digest_set_has(&s->events, found.list[i].order))
            s->pruned++;
        else if (digest_set_add(&s->tried, found.list[i].order))
            s->flips[s->flip_count++] = (struct flip_of_run){.flip = found.list[i], .run = run};
    free(found.list);
}

/* Looks at a run whose order is new: what happened in it, and what could have. */
static void look_at(struct search *s, const json_t *record, size_t run)
{
    char *error = NULL, *path = batch_recording(s->place, s->runs[run].key);
    struct recording *r = recording_load(path, &error);
    if (r) {
        s->base_nodes = r->nodes;
        s->programs = s->programs ? s->programs : recording_programs(r);
        struct event_rows t = event_rows_of(r);
        struct order o = order_of(r, &t);
        struct clocks c = clocks_of(r, &t, MOST_CLOCKS);
        for (size_t i = 0; i < t.count; i++)
            digest_set_add(&s->events, o.event[i]);
        add_flips(s, &o, &c, record, run);
        clocks_free(&c);
        order_free(&o);
        event_rows_free(&t);
    }
    recording_free(r);
    free(error);
    free(path);
}

/* An order that runs have had with other outputs is known under these, too. */
static struct digest order_and_outcome(struct digest order, size_t outcome)
{
    uint64_t word[] = {order.high, order.low, outcome};
    return digest_of(word, sizeof word);
}

static void take_order(struct search *s, const json_t *record, size_t run)
{
    const char *text = json_string_value(json_object_get(record, "order"));
    struct explored *e = &s->runs[run];
    struct digest order;
    if (!text || !digest_read(text, &order))
        return;
    bool new_order = digest_set_add(&s->orders, order);
    bool new_pair = digest_set_add(&s->tried, order_and_outcome(order, e->outcome));
    s->times_differ |= !new_order && new_pair;
    struct outcome_group *g = &s->outcomes[e->outcome];
    g->same_order = !new_order && e->outcome && (g->runs == 1 || g->same_order);
    e->recorded = new_pair;
    if (new_order)
        look_at(s, record, run);
    if (!new_pair) { /* an equal recording is there already */
        char *path = batch_recording(s->place, e->key);
        unlink(path);
        free(path);
    }
}

/* Did the run print its lines in another order than the first of its outcome? */
static bool reordered(const struct outcome_group *g, const json_t *record)
{
    const json_t *first = json_object_get(g->record, "lines"), *lines = json_object_get(record, "lines");
    return first && lines && !json_equal(first, lines);
}

static void take_one(struct search *s, const struct planned_run *r)
{
    s->runs = xgrown(s->runs, s->run_count, sizeof *s->runs);
    size_t run = s->run_count, outcome = outcome_of(s, r);
    struct outcome_group *g = &s->outcomes[outcome];
    s->runs[run] = (struct explored){
        .name = xstrdup(r->name),
        .timing = r->timing ? xstrdup(r->timing) : NULL,
        .schedule = r->schedule ? xstrdup(r->schedule) : NULL,
        .key = r->key,
        .outcome = outcome,
        .delays = (size_t)json_integer_value(json_object_get(r->record, "delays")),
    };
    s->run_count++;
    g->runs++;
    g->reordered += reordered(g, r->record);
    take_order(s, r->record, run);
    const struct explored *e = &s->runs[run], *least = &s->runs[g->least];
    if (e->recorded && (!least->recorded || e->delays < least->delays))
        g->least = run;
}

void search_take(struct search *s, const struct planned_run *runs, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (runs[i].record)
            take_one(s, &runs[i]);
        else
            s->failed += runs[i].failure != NULL;
}

void search_free(struct search *s)
{
    for (size_t i = 0; i < s->run_count; i++) {
        free(s->runs[i].name);
        free(s->runs[i].timing);
        free(s->runs[i].schedule);
    }
    for (size_t i = 0; i < s->outcome_count; i++)
        json_decref(s->outcomes[i].record);
    free(s->runs);
    free(s->outcomes);
    free(s->flips);
    free(s->places);
    digest_set_free(&s->orders);
    digest_set_free(&s->events);
    digest_set_free(&s->tried);
    digest_set_free(&s->keys);
}
