/* study.c - study files (lab/study/spec.h), their expressions, and the points that they make. */
#include <jansson.h>
#include <stdlib.h>
#include "fuzz.h"
#include "files/words.h"
#include "lab/study/points.h"
#include "lab/study/spec_read.h"

enum { MOST_POINTS = 50 };

static void use(const struct spec *s, const struct point *p)
{
    free(point_name(s, p));
    point_nodes(s, p);
    point_machine(s, p);
    words_free(point_arguments(s, p));
    words_free(point_settings(s, p));
    json_t *values = point_values(s, p);
    struct point chosen;
    char *error = NULL;
    point_choose(s, values, &chosen, &error);
    free(error);
    json_decref(values);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char *path = fuzz_path("fuzzed.cfg"), *error = NULL;
    fuzz_file("fuzzed.cfg", bytes, size);
    struct spec *s = spec_read(path, &error);
    if (!s)
        fuzz_refused(error, "/"); /* it may include another file */
    for (size_t i = 0; s && i < s->product && i < MOST_POINTS; i++) {
        struct point p;
        char *wrong = NULL;
        enum point_is is = point_make(s, i, &p, &wrong);
        if (is == POINT_WANTED)
            use(s, &p);
        else if (is == POINT_WRONG)
            fuzz_refused(wrong, "/");
    }
    spec_free(s);
    free(path);
    return 0;
}
