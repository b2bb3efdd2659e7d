/* delta.h - the least of a list that still shows something: delta debugging (Zeller & Hildebrandt,
 * "Simplifying and isolating failure-inducing input", IEEE TSE 28(2), 2002), algorithm ddmin. */
#ifndef LAB_EXPLORE_DELTA_H
#define LAB_EXPLORE_DELTA_H
#include <stdbool.h>
#include <stddef.h>

/* Tests parts of the list at once: kept[i][j] says whether the i-th part has the list's j-th item. Sets
 * shows[i]. False: the tests cannot be made, and delta_least() ends with what it has. */
typedef bool delta_test(void *arg, unsigned char *const kept[], size_t parts, bool shows[]);

/* Removes from kept (1 for each of the list's items) as many items as it can such that the rest still shows,
 * with at most `tests` tests. True: the rest is 1-minimal, without any one of its items it does not show.
 * False: the tests ended before. The whole list is taken to show. */
bool delta_least(unsigned char *kept, size_t count, size_t tests, delta_test *test, void *arg);
#endif
