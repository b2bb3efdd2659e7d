/* spec_read.h - reads a study file (spec.h). */
#ifndef LAB_STUDY_SPEC_READ_H
#define LAB_STUDY_SPEC_READ_H
#include "lab/study/spec.h"

/* path must outlive the spec. NULL with *error malloc'd: file:line: key: what is wrong. */
struct spec *spec_read(const char *path, char **error);
void spec_free(struct spec *s);
#endif
