/* spec_pictures.h - reads the pictures of a study file. */
#ifndef LAB_STUDY_SPEC_PICTURES_H
#define LAB_STUDY_SPEC_PICTURES_H
#include "lab/study/spec.h"

/* Call after spec_read_axes(). False with an error in r; s->pictures is malloc'd. */
bool spec_read_pictures(struct cfg_reader *r, struct spec *s);
#endif
