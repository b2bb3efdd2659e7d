/* judge.c - how far our figures are from the published ones. */
#include "validate.h"
#include <math.h>
#include <string.h>

const char *verdict_name(enum verdict v)
{
    static const char *const names[] = {"within", "OUTSIDE", "misses", "open"};
    return names[v];
}

static void judge_figure(struct figure *f)
{
    f->simulated = NAN;
    for (size_t i = 0; i < f->run->found_count; i++)
        if (strcmp(f->run->found[i].name, f->name) == 0)
            f->simulated = f->run->found[i].value;
    if (f->open) {
        f->verdict = isnan(f->simulated) ? OUTSIDE : OPEN;
        return;
    }
    double nearest = f->simulated < f->low ? f->low : f->simulated > f->high ? f->high : f->simulated;
    f->error = nearest == 0 ? 0 : (f->simulated - nearest) / nearest;
    f->verdict = fabs(f->error) <= f->within       ? WITHIN
                 : f->miss && !isnan(f->simulated) ? KNOWN_MISS
                                                   : OUTSIDE;
}

static double formula(const struct curve *c, const struct point *p)
{
    size_t i = 0;
    while (i + 1 < c->piece_count && p->x[0] > c->pieces[i].most)
        i++;
    return c->pieces[i].constant + c->pieces[i].per_x * p->x[0] + c->pieces[i].per_y * p->x[1];
}

static void judge_curve(struct curve *c)
{
    for (size_t i = 0; i < c->run->point_count; i++) {
        const struct point *p = &c->run->points[i];
        if (strcmp(p->series, c->series) != 0)
            continue;
        double error = p->y / formula(c, p) - 1;
        if (!c->worst_at || fabs(error) > fabs(c->worst))
            c->worst = error, c->worst_at = p;
        c->points++;
    }
    c->verdict = c->points && fabs(c->worst) <= c->within ? WITHIN : OUTSIDE;
}

bool judge(struct plan *p)
{
    bool good = true;
    for (size_t i = 0; i < p->figure_count; i++) {
        judge_figure(&p->figures[i]);
        good = good && p->figures[i].verdict != OUTSIDE;
    }
    for (size_t i = 0; i < p->curve_count; i++) {
        judge_curve(&p->curves[i]);
        good = good && p->curves[i].verdict != OUTSIDE;
    }
    return good;
}
