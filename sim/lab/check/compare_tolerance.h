/* compare_tolerance.h - the figures that are compared with a baseline's (touchstone check --only), and how
 * much they may differ (--tolerance). */
#ifndef LAB_CHECK_COMPARE_TOLERANCE_H
#define LAB_CHECK_COMPARE_TOLERANCE_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

struct compare_tolerance {
    char *figure;   /* NULL: all costs and speeds without a tolerance of their own */
    double allowed; /* a part of the baseline's value if relative, otherwise in the figure's unit */
    bool relative;
};

struct compare_rules {
    struct compare_tolerance *tolerances;
    size_t count;
    bool exact;       /* any difference is worse, in any figure */
    const char *only; /* the one figure that is compared; NULL: all */
};

/* Adds tolerances: "0.5%", "total_s=1%", "messages=10", or a list of such texts with commas. False with *why
 * malloc'd. */
bool compare_rules_add(struct compare_rules *rules, const char *text, char **why);
void compare_rules_clear(struct compare_rules *rules);
/* The first figure that rules name and that is none of these, an object's keys; NULL if there is none. */
const char *compare_rules_unused(const struct compare_rules *rules, const json_t *figures);
#endif
