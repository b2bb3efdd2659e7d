/* point_request.h - what a page asks to be run, checked against the study file and the machine file. */
#ifndef LAB_SERVE_POINT_REQUEST_H
#define LAB_SERVE_POINT_REQUEST_H
#include "lab/study/point_run.h"

struct point_request {
    struct digest key; /* of the point's inputs */
    json_t *values;    /* on each axis, the derived ones, too */
    json_t *set;       /* settings of this point only: [KEY=NUMBER ...] */
    char *name;        /* for people */
    char **argv;       /* the run's command */
    char *json;        /* where the run writes its figures */
    char *dir;         /* where it works: the study file's folder */
    double limit_s;    /* of host time; 0: none */
};

struct point_request_places {
    const char *runner, *machines;
    const char *scratch; /* the folder for json, whose name has the number */
    unsigned number;
};

/* Reads a request (added_runs.h) for the study of that note (lab/study/study_note.h; NULL: there is none).
 * False with *error malloc'd. Otherwise point_request_clear() is due. */
bool point_request_read(struct point_request *r, const json_t *note, const json_t *request,
                        const struct point_request_places *places, char **error);
void point_request_clear(struct point_request *r);

/* The axes that a page can choose on: [{ name, open, values }]; open: any number is allowed, otherwise one of
 * the values. { error } if points cannot be run, and why. The caller owns it. */
json_t *point_request_form(const json_t *note);
#endif
