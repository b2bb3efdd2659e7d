/* record.h - a study's results as files: written a point at a time, as they come, and read. Only figures whose name holds
 * "wall_time" differ between two runs of one study. */
#ifndef LAB_CHART_RECORD_H
#define LAB_CHART_RECORD_H
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

/* Where points come from: each is one flat object (study.h). They may be asked for several times. */
struct record_points {
    bool (*each)(void *arg, bool (*visit)(void *to, const json_t *point, char **error), void *to,
                 char **error);
    void *arg;
    json_t *header; /* { title, about, program, axes: { NAME: [value ...] } } */
};

/* DIR/results.json: the header with points: [{ AXIS: value ..., failure, KEY: figure ... }]; and DIR/results.csv: a line of
 * names, and one for each point, without figures that are lists. Each is there whole or not at all. */
bool record_write_json(const struct record_points *points, const char *dir, char **error);
bool record_write_csv(const struct record_points *points, const char *dir, char **error);

/* Reads results.json, all of it into memory: free with record_free(). False with *error malloc'd. */
bool record_read(const char *path, struct record_points *points, char **error);
void record_free(struct record_points *points);
#endif
