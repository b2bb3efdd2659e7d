/* why_path_lines.h - the critical path as text, a line a step. */
#ifndef LAB_WHY_PATH_LINES_H
#define LAB_WHY_PATH_LINES_H
#include <stdio.h>
#include "lab/why/why.h"

/* Writes each step in a line, in the order of time, below a line of titles. */
void why_path_lines(struct why *w, FILE *f);
#endif
