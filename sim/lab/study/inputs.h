/* inputs.h - all that a point's result depends on, and its digest: the point's identity.
 *
 *     touchstone   the bytes of the simulator        libc         the host's library: some of its functions are the nodes'
 *     program      the bytes of its image            nodes, arguments
 *     machine      the machine file as read, with what it includes; and the point's settings
 *     inputs       name and bytes of each file that the study names
 *     profile      whether the run has one
 *
 * Equal digests: the same figures, to the last bit, but for wall times. Taking it checks the machine's settings as a run
 * would, so that mistakes are found before anything is run.
 */
#ifndef LAB_STUDY_INPUTS_H
#define LAB_STUDY_INPUTS_H
#include "lab/jobs/digest.h"
#include "lab/study/points.h"

/* Where things are. All must outlive what is made of it. */
struct inputs_places {
    const char *runner;     /* the touchstone that runs a point */
    const char *program;    /* the study's program, as a path */
    const char *machines;   /* the folder of machine files */
    const char *dir;        /* the study file's folder */
    const char *const *set; /* settings of every point's machine beside its own, ended by NULL; or NULL */
    const char *const *arguments; /* words after every point's own, ended by NULL; or NULL */
};

/* Reads what all points share. NULL with *error a malloc'd text for the user. */
struct inputs *inputs_open(const struct spec *s, const struct inputs_places *places, char **error);
void inputs_close(struct inputs *in);

/* The point's inputs and their digest; *all, unless NULL, is them as an object, the caller's. False with *error
 * malloc'd: file:line: key: what is wrong and what is allowed. */
bool inputs_of(struct inputs *in, const struct point *p, struct digest *key, json_t **all, char **error);

/* All settings of the point's machine, in the order in which they are applied; for words_free(). */
char **inputs_settings(const struct inputs *in, const struct point *p);

/* A machine file as libconfig writes it, without comments and with what it includes. False: it cannot be read. */
bool inputs_machine_file(const char *path, struct digest *d);
/* The program's arguments. */
char **inputs_arguments(const struct inputs *in, const struct point *p);
#endif
