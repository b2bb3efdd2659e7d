/* json_set.h - members of JSON objects, and their names. Where one cannot be set, the function does not
 * return: it writes to standard error which it is and ends the process with status 1. jansson fails for want
 * of memory, and for a text that is not UTF-8. */
#ifndef FILES_JSON_SET_H
#define FILES_JSON_SET_H
#include <jansson.h>
#include "kernel/vtime.h"

/* Sets object's member of that key. Takes over value, as json_object_set_new(); json_incref() keeps it. */
void json_set(json_t *object, const char *key, json_t *value);
/* Adds value at the list's end and takes it over. */
void json_append(json_t *list, json_t *value);

/* Null for what JSON has no number for (NAN, infinities); for NULL. */
json_t *json_real_or_null(double x);
json_t *json_string_or_null(const char *text);

/* A whole number of picoseconds; from 2^63 on, which is more than integers of JSON's readers have, a real
 * number. */
json_t *json_ps(vtime_sum t);

/* A string; of a text that is not UTF-8, with ? for each byte that is not ASCII. */
json_t *json_text(const char *text);
/* An array of such. list is ended by NULL, or is NULL. */
json_t *json_texts(char *const list[]);

/* An object's keys, but for those that `without` (NULL: none) has: "idle_s, messages, total_s", malloc'd. */
char *json_keys_text(const json_t *object, const json_t *without);
#endif
