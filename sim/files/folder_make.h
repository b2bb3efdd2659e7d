/* folder_make.h - folders for results. */
#ifndef FILES_FOLDER_MAKE_H
#define FILES_FOLDER_MAKE_H
#include <stdbool.h>
#include "files/scratch.h"

/* Makes path and what is missing above it; false with errno. */
bool folder_make(const char *path);
/* scratch_new, with path NULL and *error a malloc'd text for the user if it cannot be made. */
struct scratch folder_scratch(const char *name, char **error);
#endif
