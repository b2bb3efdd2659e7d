/* point_run.h - a point as a run of touchstone: its command, its environment, and what it came to. */
#ifndef LAB_STUDY_POINT_RUN_H
#define LAB_STUDY_POINT_RUN_H
#include "lab/jobs/outcome.h"
#include "lab/study/inputs.h"

/* Paths; profile NULL: the run has none. */
struct point_run_files {
    const char *runner, *program, *json, *profile;
};

/* The command, ended by NULL, to be freed by words_free(). It works in the study file's folder. */
char **point_run_argv(const struct spec *spec, const struct inputs *inputs, const struct point *p,
                      const struct point_run_files *files);
/* The environment of a run whose temporary files are in that folder; to be freed by words_free(). */
char **point_run_environment(const char *scratch);

/* The record of a run for the journal, without its point: { wall_time_s, figures, profile }, or
 * { wall_time_s, failure }. profile: the file, or NULL. The caller owns it. */
json_t *point_record(const struct outcome *o, const char *profile, double wall_time_s);
json_t *point_record_of_failure(const char *error, double wall_time_s);
/* The point in one object, of its values, which it takes over, and its record: { AXIS..., failure,
 * wall_time_s, FIGURE..., time_s }, without speeds and profile. */
json_t *point_flat(json_t *values, const json_t *record);
#endif
