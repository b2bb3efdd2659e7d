/* explain_json.h - where the time of a row went (explain.h), as JSON. */
#ifndef LAB_TABLES_EXPLAIN_JSON_H
#define LAB_TABLES_EXPLAIN_JSON_H
#include <jansson.h>
#include "lab/tables/explain.h"

/* share/schemas/explain.schema.json says what there is. */
json_t *explain_json(const struct explain *e);
#endif
