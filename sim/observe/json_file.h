/* json_file.h - what the JSON files of a run have in common. */
#ifndef OBSERVE_JSON_FILE_H
#define OBSERVE_JSON_FILE_H
#include <jansson.h>
#include "node/node.h"

/* Writes the file, whole or not at all: first under a temporary name, which is then renamed. Takes over root.
 * Returns NULL, or a malloc'd error. */
char *json_file_write(json_t *root, const char *path);

/* An object: the system's time by task. */
json_t *json_tasks(const double seconds[NODE_TASKS]);
#endif
