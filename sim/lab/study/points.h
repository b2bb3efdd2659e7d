/* points.h - the points of a study, made one at a time from their numbers: the product of all axes, the last
 * axis changing fastest, without the points that the study leaves out. */
#ifndef LAB_STUDY_POINTS_H
#define LAB_STUDY_POINTS_H
#include "files/words.h"
#include "lab/study/spec.h"

#include <jansson.h>

/* Must not be copied: value[] points into label[]. */
struct point {
    size_t number;                          /* below spec.product */
    struct expr_value value[SPEC_MAX_AXES]; /* on each axis: number (NAN if none) and text */
    char label[SPEC_MAX_AXES][SPEC_MAX_LABEL];
};

enum point_is {
    POINT_WANTED,
    POINT_LEFT_OUT, /* a condition of `only` does not hold */
    POINT_WRONG,    /* a derived value is invalid: *error is a malloc'd text, file:line: key: ... */
};
enum point_is point_make(const struct spec *s, size_t number, struct point *p, char **error);

/* May the axis have values that the study file does not name? An axis of numbers may, whose settings and
 * arguments are equal for all values. */
bool point_axis_is_open(const struct spec_axis *axis);
/* As point_make(), of values given as texts or numbers: AXIS: value for each axis that is not derived. A
 * value is one of the study file, or any number on an open axis. POINT_WRONG and POINT_LEFT_OUT with
 * *error. */
enum point_is point_choose(const struct spec *s, const json_t *values, struct point *p, char **error);

/* The point's name, malloc'd: "nodes 16, group 2". */
char *point_name(const struct spec *s, const struct point *p);
uint64_t point_nodes(const struct spec *s, const struct point *p);
const char *point_machine(const struct spec *s, const struct point *p);
/* The program's arguments, and the settings KEY=VALUE of its machine: ended by NULL, to be freed by
 * words_free(). */
char **point_arguments(const struct spec *s, const struct point *p);
char **point_settings(const struct spec *s, const struct point *p);
/* Where the study file has the i'th setting of point_settings(), for messages. */
config_setting_t *point_setting_at(const struct spec *s, const struct point *p, size_t i);
/* AXIS: value of each axis, whole numbers as integers. */
json_t *point_values(const struct spec *s, const struct point *p);
json_t *point_value_json(double number, const char *text);
#endif
