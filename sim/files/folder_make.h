/* folder_make.h - makes folders for results and for temporary files. */
#ifndef FILES_FOLDER_MAKE_H
#define FILES_FOLDER_MAKE_H
#include <stdbool.h>
#include "files/scratch.h"

/* Makes the folder and all missing folders above it. False with errno. */
bool folder_make(const char *path);
/* As scratch_new(); if the folder cannot be made, path is NULL and *error a malloc'd text for the user. */
struct scratch folder_scratch(const char *name, char **error);
#endif
