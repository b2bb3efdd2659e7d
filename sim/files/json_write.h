/* json_write.h - a JSON value as a result file. */
#ifndef FILES_JSON_WRITE_H
#define FILES_JSON_WRITE_H
#include <jansson.h>
#include <stdbool.h>

/* A double survives 17 digits bit by bit; with 15 it reads as people write it: 0.1. */
enum { JSON_ALL_DIGITS = 17, JSON_READABLE_DIGITS = 15 };

/* Writes the file, whole or not at all (atomic_file.h), and takes over value. False with *error, a malloc'd
 * text for the user. */
bool json_write(json_t *value, const char *path, int digits, char **error);
#endif
