/* expr.h - expressions over named values: "nodes / 4", "group <= nodes && output != 'no files'".
 *
 *     or     ||                         a condition is 1 where it holds, else 0; anything but 0 holds
 *     and    &&
 *     is     < <= = == != >= >          texts are only equal or not
 *     sum    + -
 *     times  * / %
 *     power  ^                          from the right; above it the signs - and !
 *     5  2.5e3  NAME  'text'  ( ... )  min(a, b) max(a, b) floor(a) ceil(a) round(a) sqrt(a) log2(a) abs(a) if(c, a, b)
 *
 * A name is the longest one that is known: with names a and a-b, "a-b" is the second. A text that is one word of
 * letters needs no quotes. Whether all fits together is checked on reading: a text can only be compared, and only with
 * what its partner can be.
 */
#ifndef LAB_STUDY_EXPR_H
#define LAB_STUDY_EXPR_H
#include <stdbool.h>
#include <stddef.h>

/* What a name stands for: a number, or one of some texts. */
struct expr_name {
    const char *name;
    bool numeric;
    const char *(*text)(void *arg,
                        size_t i); /* the i'th text it can be, NULL after the last; unless numeric */
    void *arg;
};

struct expr_value {
    double number;
    const char *text; /* of a name that is not numeric */
};

/* Reads text, in which the names are known; they may go afterwards. NULL with *why malloc'd: what is wrong, and what is
 * allowed. */
struct expr *expr_read(const char *text, const struct expr_name names[], size_t count, char **why);
void expr_free(struct expr *e);

/* Its number; values are those of the names, in their order. What has no number (1 / 0) is NAN or infinite. */
double expr_number(const struct expr *e, const struct expr_value values[]);
/* Does it depend on the i'th name? */
bool expr_uses(const struct expr *e, size_t i);
const char *expr_text(const struct expr *e); /* as it was read */
#endif
