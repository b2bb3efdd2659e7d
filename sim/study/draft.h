/* draft.h - a file that is there whole or not at all: written under another name, then renamed. */
#ifndef STUDY_DRAFT_H
#define STUDY_DRAFT_H
#include <stdbool.h>
#include <stdio.h>

struct draft {
    FILE *out; /* write here */
    char *path, *unfinished;
};

/* Begins DIR/NAME. false with *error a malloc'd text for the user. */
bool draft_begin(struct draft *d, const char *dir, const char *name, char **error);
/* Ends it, and makes it there under its name if all was written. */
bool draft_end(struct draft *d, char **error);
/* Ends it without a trace. */
void draft_drop(struct draft *d);
#endif
