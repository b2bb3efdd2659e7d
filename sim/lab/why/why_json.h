/* why_json.h - the analysis of why a run took its time, as JSON. All times are virtual, in whole
 * picoseconds (members "..._ps"). */
#ifndef LAB_WHY_JSON_H
#define LAB_WHY_JSON_H
#include <jansson.h>
#include "lab/why/why_report.h"

/* An object; with_path: it has every step of the path, too. All rows, whatever o->top is. */
json_t *why_json(struct why *w, const struct why_report_options *o, bool with_path);
#endif
