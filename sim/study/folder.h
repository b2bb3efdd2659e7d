/* folder.h - folders for results, and folders that are gone afterwards. */
#ifndef STUDY_FOLDER_H
#define STUDY_FOLDER_H
#include <stdbool.h>

/* Makes path and what is missing above it; false with errno. */
bool folder_make(const char *path);
/* A new folder in TMPDIR, NAME.XXXXXX: its malloc'd path, or NULL with *error a malloc'd text for the user. */
char *folder_scratch(const char *name, char **error);
/* Removes it with all that is in it. */
void folder_remove(const char *path);
#endif
