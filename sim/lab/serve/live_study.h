/* live_study.h - a study's folder as it is now, whether its study runs or not, and the points that were added
 * to it.
 *
 *     DIR/study.json      which study it is (lab/study/study_note.h)
 *     DIR/journal         results as they come
 *     DIR/results.json    all results, after the study's end
 *     DIR/added/journal   results of points that a page has asked for; each record has also its settings,
 *                         set: [KEY=VALUE ...]
 *
 * A later session of the study leaves DIR/added as it is. */
#ifndef LAB_SERVE_LIVE_STUDY_H
#define LAB_SERVE_LIVE_STUDY_H
#include <stdio.h>
#include "lab/jobs/digest.h"
#include "lab/serve/journal_points.h"
#include "lab/serve/study_folder.h"

struct live_study {
    char *name;        /* as the user gave it */
    int folder, added; /* open; added -1: nothing was added yet */
    unsigned version;  /* of what it shows; grows */
    json_t *note;      /* study.json, or NULL */
    json_t *results;   /* results.json, or NULL */
    bool running;      /* a process runs the study */
    struct journal_points own, more;
    struct watched_file note_file, journal_file, results_file, added_file;
};

/* Is that the folder of a study? */
bool live_study_is(const char *dir);
/* NULL with *error malloc'd. */
struct live_study *live_study_open(const char *dir, char **error);
void live_study_close(struct live_study *s);

/* Reads what has changed. */
void live_study_look(struct live_study *s);

/* How far the study is: { version, all, done, failed, running }; the caller owns it. */
json_t *live_study_progress(const struct live_study *s);
/* All there is to show, as results.json has it, with the added points (added: true) among the others, and
 * an axis `set` if points with settings were added; and progress. The caller owns it. */
json_t *live_study_data(const struct live_study *s);
/* The results in the folder, with the points that were added to them, as live_study_data() gives them. NULL:
 * there are no results, or nothing was added. The caller owns it. */
json_t *live_study_results_with_added(const char *dir);
/* Has it a result of the point with these values and settings? */
bool live_study_has(const struct live_study *s, const json_t *values, const json_t *set);
/* Can the record of a point be written into its folder? False with *error malloc'd. */
bool live_study_can_add(struct live_study *s, char **error);
/* Adds the record of a point. False with *error malloc'd. */
bool live_study_add(struct live_study *s, struct digest key, json_t *record, FILE *notes, char **error);
#endif
