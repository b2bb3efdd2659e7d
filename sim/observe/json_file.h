/* json_file.h - what the JSON files of a run have in common. */
#ifndef OBSERVE_JSON_FILE_H
#define OBSERVE_JSON_FILE_H
#include <jansson.h>
#include "node/node.h"

/* Writes the file, whole or not at all: first under a temporary name, which is then renamed. Takes over root.
 * Returns NULL, or a malloc'd error. */
char *json_file_write(json_t *root, const char *path);

/* A string; of a text that is not UTF-8, with ? for each byte that is not ASCII. */
json_t *json_text(const char *text);
/* An array of strings. list is ended by NULL, or is NULL. */
json_t *json_texts(char *const list[]);
/* An object: the system's time in seconds by task. */
json_t *json_tasks(const vtime tasks[NODE_TASKS]);
#endif
