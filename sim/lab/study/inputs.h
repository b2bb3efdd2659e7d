/* inputs.h - everything that a point's result depends on, and its digest: the point's identity.
 *
 *     touchstone   the bytes of the simulator
 *     libc         the version of the host's library: nodes use some of its functions
 *     program      the bytes of the program's image
 *     nodes, arguments
 *     machine      the machine file as read, with what it includes; and the point's settings
 *     inputs       name and bytes of each file that the study names
 *     profile      whether the run has a profile
 *
 * Points of equal digests have equal figures, to the last bit, except for host times. Taking a digest checks
 * the machine's settings as a run would: mistakes are found before any point is run.
 */
#ifndef LAB_STUDY_INPUTS_H
#define LAB_STUDY_INPUTS_H
#include "lab/jobs/digest.h"
#include "lab/study/points.h"

/* Paths and settings that do not depend on the point. All must outlive the struct inputs. */
struct inputs_paths {
    const char *runner;     /* the touchstone that runs a point */
    const char *program;    /* the study's program, as a path */
    const char *machines;   /* the folder of machine files */
    const char *dir;        /* the study file's folder */
    const char *const *set; /* more settings KEY=VALUE of every point's machine, ended by NULL; or NULL */
    const char *const *arguments; /* more arguments of every point's program, ended by NULL; or NULL */
};

/* Reads the inputs that all points share. NULL with *error malloc'd. */
struct inputs *inputs_open(const struct spec *s, const struct inputs_paths *paths, char **error);
void inputs_close(struct inputs *in);

/* Sets *key to the digest of the point's inputs and, unless all is NULL, *all to the inputs as an object,
 * owned by the caller. False with *error malloc'd: file:line: key: what is wrong and what is allowed. */
bool inputs_of(struct inputs *in, const struct point *p, struct digest *key, json_t **all, char **error);

/* All settings of the point's machine, in the order of application; to be freed by words_free(). */
char **inputs_settings(const struct inputs *in, const struct point *p);
/* All arguments of the point's program; to be freed by words_free(). */
char **inputs_arguments(const struct inputs *in, const struct point *p);

/* The digest of a machine file as libconfig writes it: without comments, with what it includes. False if the
 * file cannot be read. */
bool inputs_machine_file(const char *path, struct digest *d);
#endif
