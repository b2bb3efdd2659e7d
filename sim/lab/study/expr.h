/* expr.h - expressions over named values: "nodes / 4", "group <= nodes && output != 'no files'".
 *
 *     or          ||                       a condition is 1 if it holds, otherwise 0; any value but 0 holds
 *     and         &&
 *     comparison  < <= = == != >= >        texts can only be compared by = and !=
 *     sum         + -
 *     product     * / %
 *     power       ^                        right-associative; binds less than the signs - and !
 *     operand     5  2.5e3  NAME  'text'  ( ... )  min(a, b) max(a, b) floor(a) ceil(a) round(a) sqrt(a)
 *                 log2(a) abs(a) if(c, a, b)
 *
 * Of several known names the longest is read: with names a and a-b, "a-b" is the second. A text of one word
 * needs no quotes. Reading checks types: a text can only be compared with a name that can have its value.
 */
#ifndef LAB_STUDY_EXPR_H
#define LAB_STUDY_EXPR_H
#include <stdbool.h>
#include <stddef.h>

/* What a name stands for: a number, or one of several texts. */
struct expr_name {
    const char *name;
    bool numeric;
    const char *(*text)(void *arg, size_t i); /* unless numeric: the i'th text, NULL after the last */
    void *arg;
};

struct expr_value {
    double number;
    const char *text; /* for a name that is not numeric */
};

/* Reads an expression over these names, which need not outlive the call. NULL with *why malloc'd: what is
 * wrong, and what is allowed. */
struct expr *expr_read(const char *text, const struct expr_name names[], size_t count, char **why);
void expr_free(struct expr *e);

/* The expression's value; values has those of the names, in their order. 1 / 0 is infinite, 0 / 0 NAN. */
double expr_number(const struct expr *e, const struct expr_value values[]);
/* Does the expression use the i'th name? */
bool expr_uses(const struct expr *e, size_t i);
/* The text that was read. */
const char *expr_text(const struct expr *e);
#endif
