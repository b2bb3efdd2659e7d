/* explore_json.h - what an exploration has found, as JSON (doc/explore.md describes the members). */
#ifndef LAB_EXPLORE_EXPLORE_JSON_H
#define LAB_EXPLORE_EXPLORE_JSON_H
#include "lab/explore/explore.h"

/* Writes the file, as an atomic one. False with *error malloc'd. */
bool explore_json(const struct explore *x, const char *path, char **error);
#endif
