/* condition.h - "group <= nodes": which points a study runs.
 *
 * Two sides and one of < <= = != >= > between them, with blanks. A side is an axis, a number, or a value's text; texts
 * are only equal or not.
 */
#ifndef STUDY_CONDITION_H
#define STUDY_CONDITION_H
#include "study/spec.h"

struct condition_side {
    const struct spec_axis *axis; /* NULL: the rest holds */
    char *text;
    double number; /* NAN: a text */
};

struct condition {
    struct condition_side left, right;
    bool less, equal, greater; /* it holds if left is ... right */
    bool ordered;              /* the comparison needs numbers */
};

/* Reads text; false with *why malloc'd, what is wrong and what is allowed. condition_clear() is due in either case. */
bool condition_read(struct condition *c, const char *text, const struct spec *s, char **why);
/* at: for each axis of s the place of its value. */
bool condition_holds(const struct condition *c, const struct spec *s, const size_t at[]);
void condition_clear(struct condition *c);
#endif
