/* fit_json.c - the result of a fit as JSON: share/schemas/fit.schema.json; see fit_parts.h. */
#include "files/json_set.h"
#include "files/json_write.h"
#include "kernel/xalloc.h"
#include "lab/fit/fit_parts.h"

#include <stdlib.h>

static json_t *parameters_json(const struct fit *f, const struct fit_result *r)
{
    json_t *list = xchecked(json_array());
    for (size_t i = 0; i < f->parameters; i++) {
        const struct fit_parameter *p = &f->parameter[i];
        char *note = fit_note(f, r, i);
        json_append(list, xchecked(json_pack("{s:s, s:f, s:f, s:f, s:f, s:o, s:b, s:s}", "name", p->name,
                                             "from", p->from, "to", p->to, "start", strtod(r->start[i], NULL),
                                             "fitted", strtod(r->text[i], NULL), "standard_error",
                                             json_real_or_null(r->error[i]), "determined",
                                             (int)(r->number[i].standing == FIT_DETERMINED), "note", note)));
        free(note);
    }
    return list;
}

static json_t *sensitivities_json(const struct fit *f, const struct fit_result *r, size_t measurement)
{
    json_t *all = xchecked(json_object());
    for (size_t n = 0; n < f->parameters; n++)
        json_set(all, f->parameter[n].name, json_real_or_null(r->percent[measurement * f->parameters + n]));
    return all;
}

static json_t *measurements_json(const struct fit *f, const struct fit_result *r)
{
    json_t *list = xchecked(json_array());
    for (size_t i = 0; i < f->measurements; i++) {
        const struct fit_measurement *m = &f->measurement[i];
        json_append(list, xchecked(json_pack("{s:s, s:f, s:o, s:o, s:o}", "name", m->name, "measured",
                                             m->value, "at_start", json_real_or_null(r->before[i]), "fitted",
                                             json_real_or_null(r->after[i]), "sensitivity_pct",
                                             sensitivities_json(f, r, i))));
    }
    return list;
}

bool fit_write_json(const struct fit *f, const struct fit_result *r, char **error)
{
    if (!f->options->json)
        return true;
    json_t *all = xchecked(
        json_pack("{s:s, s:o, s:o, s:s, s:o, s:o, s:I}", "format", "touchstone fit 1", "parameters",
                  parameters_json(f, r), "measurements", measurements_json(f, r), "rms_of",
                  f->by_rounding ? "rounding" : "percent", "rms_at_start", json_real_or_null(r->rms_before),
                  "rms_fitted", json_real_or_null(r->rms_after), "evaluations", (json_int_t)f->evaluations));
    return json_write(all, f->options->json, JSON_READABLE_DIGITS, error);
}
