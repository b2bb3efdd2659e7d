/* spec_axes.h - reads the axes of a study file: lists, ranges, cases and derived axes. */
#ifndef LAB_STUDY_SPEC_AXES_H
#define LAB_STUDY_SPEC_AXES_H
#include "lab/study/spec.h"

/* False with an error in r. Either way spec_free_axes() is due. */
bool spec_read_axes(struct cfg_reader *r, struct spec *s);
void spec_free_axes(struct spec *s);
#endif
