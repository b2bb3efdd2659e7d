/* baseline.c - baselines (lab/check/baseline.h): each point compared with the point before it. */
#include "lab/check/baseline.h"
#include <stdlib.h>
#include "fuzz.h"
#include "lab/check/compare.h"

static void compare_all(json_t *points, const char *study)
{
    static const struct compare_rules RULES = {0};
    const char *name;
    json_t *point, *before = NULL;
    json_object_foreach(points, name, point)
    {
        compare_free(compare_point(study, name, before, point, NULL, &RULES));
        before = point;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char *path = fuzz_path("baseline.json"), *error = NULL;
    const char *study;
    json_t *points;
    fuzz_file("baseline.json", bytes, size);
    json_t *root = baseline_read(path, &error);
    if (!root)
        fuzz_refused(error, path);
    json_object_foreach(json_object_get(root, "studies"), study, points) compare_all(points, study);
    json_decref(root);
    free(path);
    return 0;
}
