/* json_set.h - members of JSON objects. Neither function returns if it fails: it writes to standard error
 * which member cannot be set and ends the process with status 1. jansson fails for want of memory, and for a
 * text that is not UTF-8. */
#ifndef FILES_JSON_SET_H
#define FILES_JSON_SET_H
#include <jansson.h>

/* Sets object's member of that key. Takes over value, as json_object_set_new(); json_incref() keeps it. */
void json_set(json_t *object, const char *key, json_t *value);
/* Adds value at the list's end and takes it over. */
void json_append(json_t *list, json_t *value);
#endif
