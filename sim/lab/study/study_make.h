/* study_make.h - touchstone study: all that a study needs, in one call. */
#ifndef LAB_STUDY_STUDY_MAKE_H
#define LAB_STUDY_STUDY_MAKE_H
#include "lab/study/study.h"

/* Opens, runs, reports and closes a study. Sets *signal to the signal that stopped it, 0 if none. */
enum study_end study_make(const struct study_options *options, int *signal, char **error);
#endif
