/* least.c - see least.h. */
#include "lab/explore/least.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "lab/explore/delta.h"

struct finding {
    struct batch_place *place;
    uint32_t nodes;
    const struct delays *all; /* of which parts are tested */
    const char *group;
    struct least *least;
    char *error;
};

static struct planned_run run_with(const struct finding *f, const unsigned char *kept)
{
    struct delays part = delays_subset(f->all, kept);
    char *text = delays_text(&part, f->nodes, "");
    char *name = xasprintf("with %zu of %zu delays", part.count, f->all->count);
    delays_free(&part);
    return planned_run(f->place->subject, name, NULL, text);
}

static bool is_of_group(const struct planned_run *r, const char *group)
{
    const char *has = json_string_value(json_object_get(r->record, "group"));
    return has && !strcmp(has, group);
}

static bool test(void *arg, unsigned char *const kept[], size_t parts, bool shows[])
{
    struct finding *f = arg;
    struct planned_run *runs = xcalloc(parts, sizeof *runs);
    for (size_t i = 0; i < parts; i++)
        runs[i] = run_with(f, kept[i]);
    bool able = batch_do(f->place, runs, parts, &f->error);
    for (size_t i = 0; i < parts; i++) {
        shows[i] = is_of_group(&runs[i], f->group);
        planned_run_free(&runs[i]);
    }
    free(runs);
    f->least->tests += parts;
    return able;
}

/* The fewest of all that show, by as many tests as are left. True: they do; then it is in *l, unless *l has
 * as few already. */
static bool narrow(struct finding *f, const struct delays *all, size_t tests, struct least *l)
{
    unsigned char *kept = xcalloc(all->count + 1, 1);
    bool shows = false;
    memset(kept, 1, all->count);
    f->all = all;
    if (l->tests < tests && test(f, &kept, 1, &shows) && shows) {
        bool is_least = delta_least(kept, all->count, tests - l->tests, test, f);
        struct delays part = delays_subset(all, kept);
        if (!l->repeats || part.count < l->delays.count) {
            struct planned_run r = run_with(f, kept);
            delays_free(&l->delays);
            l->delays = part, l->is_least = is_least, l->key = r.key;
            planned_run_free(&r);
        } else {
            delays_free(&part);
        }
    }
    free(kept);
    return shows;
}

static struct delays raised(const struct delays *d, const struct delay_bounds *bounds)
{
    struct delays all = delays_copy(d);
    for (size_t i = 0; i < all.count; i++)
        if (all.list[i].value < bounds->most[all.list[i].kind])
            all.list[i].value = bounds->most[all.list[i].kind];
    return all;
}

bool least_find(struct batch_place *place, const struct recording *r, const struct delay_bounds *bounds,
                const char *group, size_t tests, struct least *l, char **error)
{
    struct finding f = {.place = place, .nodes = r->nodes, .group = group, .least = l};
    *l = (struct least){0};
    l->repeats = narrow(&f, &r->delays, tests, l);
    if (!l->repeats)
        l->delays = delays_copy(&r->delays);
    else if (l->delays.count > 1 && !f.error && !place->signal) {
        struct delays longer = raised(&l->delays, bounds);
        narrow(&f, &longer, tests, l);
        delays_free(&longer);
    }
    *error = f.error;
    return !f.error && !place->signal;
}
