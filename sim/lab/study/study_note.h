/* study_note.h - DIR/study.json: which study a folder belongs to, for who looks at the folder while the study
 * runs or after it.
 *
 *     format                  what the file is, and its version
 *     study, program          absolute paths of the study file and of the program's image
 *     set, arguments          more of each point, as in struct study_options
 *     header                  as in results.json: { title, about, program, axes }
 *     points                  how many the study has
 *     before, journal_from    so many of them had results when the journal had so many bytes; each line
 *                             behind these bytes is the result of one more
 */
#ifndef LAB_STUDY_STUDY_NOTE_H
#define LAB_STUDY_STUDY_NOTE_H
#include "lab/study/study.h"

#define STUDY_NOTE_NAME "study.json"

/* Writes the file, as an atomic one. False with *error malloc'd. */
bool study_note_write(const struct study *s, char **error);
#endif
