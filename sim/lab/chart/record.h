/* record.h - a study's results as files. Two runs of one study differ only in figures whose name contains
 * "wall_time". */
#ifndef LAB_CHART_RECORD_H
#define LAB_CHART_RECORD_H
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

/* A source of points, each a flat object (study.h). each() may be called several times. */
struct record_points {
    bool (*each)(void *arg, bool (*visit)(void *to, const json_t *point, char **error), void *to,
                 char **error);
    void *arg;
    json_t *header; /* { title, about, program, axes: { NAME: [value ...] } } */
};

/* Write DIR/results.json, the header with points: [{ AXIS: value ..., failure, KEY: figure ... }], and
 * DIR/results.csv, a line of names and a line for each point, without figures that are lists. Points are
 * written one at a time, into atomic files (atomic_file.h). False with *error malloc'd. */
bool record_write_json(const struct record_points *points, const char *dir, char **error);
bool record_write_csv(const struct record_points *points, const char *dir, char **error);

/* Reads a results.json into memory, to be freed by record_free(). False with *error malloc'd. */
bool record_read(const char *path, struct record_points *points, char **error);

/* Says of a header's axes, or of the points' figures, that none has this name, and which there are;
 * malloc'd. */
char *record_no_axis(const json_t *axes, const char *name);
char *record_no_figure(const struct record_points *points, const char *name);
/* "did you mean nodes? There are" if one of the keys is like the name, "there are" if none is; malloc'd. */
char *record_key_meant(const json_t *keys, const char *name);
void record_free(struct record_points *points);
#endif
