/* page_deadlock.h - a report of a deadlock as a page's data: {"report": text, "svg": picture,
 * "program": its path}. */
#ifndef LAB_PAGE_PAGE_DEADLOCK_H
#define LAB_PAGE_PAGE_DEADLOCK_H
#include <jansson.h>

/* j: the report, or results of a run. NULL: no deadlock is in it. */
json_t *page_deadlock_make(const json_t *j);
#endif
