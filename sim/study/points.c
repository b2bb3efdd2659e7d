/* points.c - from axes to command lines; see points.h. */
#include "study/points.h"
#include "study/condition.h"
#include "study/outcome.h"
#include "study/text.h"

#include <stdlib.h>
#include <string.h>

/* Takes a malloc'd word on at the end of argv. */
static void add(char ***argv, char *word)
{
    size_t n = 0;
    while (*argv && (*argv)[n])
        n++;
    char **more = realloc(*argv, (n + 2) * sizeof *more);
    if (!more || !word)
        abort();
    more[n] = word;
    more[n + 1] = NULL;
    *argv = more;
}

/* The text with the value's label for each {}; malloc'd. */
static char *filled_in(const char *text, const char *label)
{
    char *done = text_of("%s", "");
    for (const char *hole; (hole = strstr(text, "{}")); text = hole + 2) {
        char *longer = text_of("%s%.*s%s", done, (int)(hole - text), text, label);
        free(done);
        done = longer;
    }
    char *all = text_of("%s%s", done, text);
    free(done);
    return all;
}

static void add_settings(char ***argv, const struct spec_value *v)
{
    for (int i = 0; v->set && i < config_setting_length(v->set); i++) {
        add(argv, text_of("--set"));
        add(argv, filled_in(config_setting_get_string_elem(v->set, i), v->label));
    }
}

static void add_words(char ***argv, const char *arguments, const char *label)
{
    char *text = filled_in(arguments ? arguments : "", label), *save;
    for (char *word = strtok_r(text, " ", &save); word; word = strtok_r(NULL, " ", &save))
        add(argv, text_of("%s", word));
    free(text);
}

/* The point's value on an axis, or NULL when there is no such axis. */
static const struct spec_value *value_of(const struct spec *s, const struct point *p, const char *name)
{
    const struct spec_axis *axis = spec_axis(s, name);
    return axis ? &axis->values[p->at[spec_place(s, axis)]] : NULL;
}

/* Files of the simulated machine's are made where TMPDIR says, and so go with the scratch folder at the latest. */
static void build_argv(const struct spec *s, struct point *p, size_t number,
                       const struct points_places *places)
{
    const struct spec_value *nodes = value_of(s, p, "nodes"), *machine = value_of(s, p, "machine");
    add(&p->argv, text_of("env"));
    add(&p->argv, text_of("TMPDIR=%s", places->scratch));
    add(&p->argv, text_of("%s", places->runner));
    add(&p->argv, text_of("run"));
    add(&p->argv, text_of("-q"));
    add(&p->argv, text_of("-m"));
    add(&p->argv, text_of("%s", machine ? machine->label : s->machine));
    add(&p->argv, text_of("-n"));
    add(&p->argv, nodes ? text_of("%s", nodes->label) : text_of("%lu", s->nodes));
    add(&p->argv, text_of("--json"));
    add(&p->argv, text_of("%s/%zu.json", places->scratch, number));
    for (size_t i = 0; i < s->axis_count; i++)
        add_settings(&p->argv, &s->axes[i].values[p->at[i]]);
    add(&p->argv, text_of("%s", places->program));
    add_words(&p->argv, s->arguments, "{}");
    for (size_t i = 0; i < s->axis_count; i++)
        add_words(&p->argv, s->axes[i].values[p->at[i]].arguments, s->axes[i].values[p->at[i]].label);
}

static char *name_of(const struct spec *s, const struct point *p)
{
    char *name = text_of("%s", "");
    for (size_t i = 0; i < s->axis_count; i++) {
        char *longer =
            text_of("%s%s%s %s", name, i ? ", " : "", s->axes[i].name, s->axes[i].values[p->at[i]].label);
        free(name);
        name = longer;
    }
    return name;
}

static bool is_wanted(const struct spec *s, const size_t at[])
{
    for (size_t i = 0; i < s->only_count; i++)
        if (!condition_holds(&s->only[i], s, at))
            return false;
    return true;
}

/* The next point of the product; false after the last. */
static bool step(const struct spec *s, size_t at[])
{
    for (size_t i = s->axis_count; i-- > 0; at[i] = 0)
        if (++at[i] < s->axes[i].count)
            return true;
    return false;
}

struct points points_plan(const struct spec *s, const struct points_places *places)
{
    struct points p = {.spec = s};
    size_t all = 1, at[SPEC_MAX_AXES] = {0};
    for (size_t i = 0; i < s->axis_count; i++)
        all *= s->axes[i].count;
    if (!(p.point = calloc(all, sizeof *p.point)))
        abort();
    do {
        if (!is_wanted(s, at))
            continue;
        struct point *point = &p.point[p.count];
        memcpy(point->at, at, sizeof at);
        point->name = name_of(s, point);
        build_argv(s, point, p.count++, places);
    } while (step(s, at));
    return p;
}

void points_free(struct points *p)
{
    for (size_t i = 0; i < p->count; i++) {
        struct point *point = &p->point[i];
        for (char **word = point->argv; *word; word++)
            free(*word);
        free(point->argv);
        free(point->name);
        free(point->failure);
        json_decref(point->figures);
    }
    free(p->point);
}

double points_figure(const struct point *p, const char *key)
{
    return figure_of(p->figures, key);
}
