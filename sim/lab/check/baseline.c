/* baseline.c - see baseline.h. */
#include "lab/check/baseline.h"
#include "files/atomic_file.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char FORMAT[] = "touchstone baseline 1";

json_t *baseline_new(void)
{
    json_t *root = json_object();
    json_set(root, "format", json_string(FORMAT));
    json_set(root, "studies", json_object());
    return root;
}

/* --- reading -------------------------------------------------------------------------------------------- */

/* What is wrong with a point; NULL if nothing is. */
static const char *wrong_point(const json_t *point)
{
    const char *key;
    json_t *class, *kind;
    if (!json_is_object(json_object_get(point, "figures")))
        return "has no figures";
    json_object_foreach(json_object_get(point, "where"), key, class)
    {
        static const char *const kinds[] = {"functions", "system", "idle"};
        for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
            if ((kind = json_object_get(class, kinds[i])) && !json_is_object(kind))
                return "has a `where` of another form";
    }
    return NULL;
}

/* Is this a baseline? False with *error malloc'd. */
static bool check(const json_t *root, const char *path, char **error)
{
    const char *format = json_string_value(json_object_get(root, "format")), *study, *name, *why;
    json_t *points, *point, *studies = json_object_get(root, "studies");
    if (!format || strcmp(format, FORMAT) != 0) {
        *error = xasprintf("%s: this is no baseline: its \"format\" is not \"%s\"", path, FORMAT);
        return false;
    }
    if (!json_is_object(studies)) {
        *error = xasprintf("%s: there is no \"studies\"", path);
        return false;
    }
    json_object_foreach(studies, study, points) json_object_foreach(points, name, point)
    {
        if ((why = wrong_point(point))) {
            *error = xasprintf("%s: %s: point \"%s\" %s", path, study, name, why);
            return false;
        }
    }
    return true;
}

json_t *baseline_read(const char *path, char **error)
{
    json_error_t why;
    json_t *root = json_load_file(path, 0, &why);
    if (!root) {
        *error =
            why.line > 0
                ? xasprintf("%s:%d: no baseline of touchstone check, which stands before the studies: %s",
                            path, why.line, why.text)
                : xasprintf("%s: %s", path, why.text);
        return NULL;
    }
    if (check(root, path, error))
        return root;
    json_decref(root);
    return NULL;
}

bool baseline_write(const json_t *baseline, const char *path, char **error)
{
    struct atomic_file d;
    if (!atomic_file_begin(&d, path, error))
        return false;
    json_dumpf(baseline, d.out, JSON_INDENT(1) | JSON_SORT_KEYS | JSON_REAL_PRECISION(15));
    fputc('\n', d.out);
    return atomic_file_end(&d, error);
}

json_t *baseline_study(json_t *baseline, const char *study)
{
    json_t *studies = json_object_get(baseline, "studies");
    if (!json_object_get(studies, study))
        json_set(studies, study, json_object());
    return json_object_get(studies, study);
}

const json_t *baseline_find(const json_t *baseline, const char *study)
{
    return json_object_get(json_object_get(baseline, "studies"), study);
}

const char *baseline_compiler(const json_t *baseline, const char *study)
{
    return json_string_value(json_object_get(json_object_get(baseline, "compilers"), study));
}

void baseline_set_compiler(json_t *baseline, const char *study, const char *compiler)
{
    if (!json_object_get(baseline, "compilers"))
        json_set(baseline, "compilers", json_object());
    json_object_del(json_object_get(baseline, "compilers"), study);
    if (compiler)
        json_set(json_object_get(baseline, "compilers"), study, json_string(compiler));
}
