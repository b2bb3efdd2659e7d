/* fit_json.c - the result of a fit as JSON: share/schemas/fit.schema.json; see fit_parts.h. */
#include "files/atomic_file.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/fit/fit_parts.h"

#include <math.h>
#include <stdlib.h>

static json_t *number(double x)
{
    return isfinite(x) ? json_real(x) : json_null();
}

static json_t *parameters_json(const struct fit *f, const struct fit_result *r)
{
    json_t *list = xchecked(json_array());
    for (size_t i = 0; i < f->parameters; i++) {
        const struct fit_parameter *p = &f->parameter[i];
        char *note = fit_note(f, r, i);
        json_append(list, xchecked(json_pack("{s:s, s:f, s:f, s:f, s:f, s:o, s:b, s:s}", "name", p->name,
                                             "from", p->from, "to", p->to, "start", strtod(r->start[i], NULL),
                                             "fitted", strtod(r->text[i], NULL), "standard_error",
                                             number(r->error[i]), "determined",
                                             (int)(r->number[i].standing == FIT_DETERMINED), "note", note)));
        free(note);
    }
    return list;
}

static json_t *sensitivities_json(const struct fit *f, const struct fit_result *r, size_t measurement)
{
    json_t *all = xchecked(json_object());
    for (size_t n = 0; n < f->parameters; n++)
        json_set(all, f->parameter[n].name, number(r->percent[measurement * f->parameters + n]));
    return all;
}

static json_t *measurements_json(const struct fit *f, const struct fit_result *r)
{
    json_t *list = xchecked(json_array());
    for (size_t i = 0; i < f->measurements; i++) {
        const struct fit_measurement *m = &f->measurement[i];
        json_append(list,
                    xchecked(json_pack("{s:s, s:f, s:o, s:o, s:o}", "name", m->name, "measured", m->value,
                                       "at_start", number(r->before[i]), "fitted", number(r->after[i]),
                                       "sensitivity_pct", sensitivities_json(f, r, i))));
    }
    return list;
}

bool fit_write_json(const struct fit *f, const struct fit_result *r, char **error)
{
    struct atomic_file file;
    if (!f->options->json)
        return true;
    if (!atomic_file_begin(&file, f->options->json, error))
        return false;
    json_t *all =
        xchecked(json_pack("{s:s, s:o, s:o, s:s, s:o, s:o, s:I}", "format", "touchstone fit 1", "parameters",
                           parameters_json(f, r), "measurements", measurements_json(f, r), "rms_of",
                           f->by_rounding ? "rounding" : "percent", "rms_at_start", number(r->rms_before),
                           "rms_fitted", number(r->rms_after), "evaluations", (json_int_t)f->evaluations));
    json_dumpf(all, file.out, JSON_INDENT(1) | JSON_REAL_PRECISION(15));
    fputc('\n', file.out);
    json_decref(all);
    return atomic_file_end(&file, error);
}
