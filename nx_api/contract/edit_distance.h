/* edit_distance.h - the edit distance of two words, which tells how alike they are: for what a user may
 * have meant. */
#ifndef CONTRACT_EDIT_DISTANCE_H
#define CONTRACT_EDIT_DISTANCE_H
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

enum { EDIT_LONGEST = 40 };

static inline size_t edit_least(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* How many letters are left out, put in, changed, or exchanged with the next one, from a to b: rows of the
 * usual table (Damerau 1964, without edits within an exchange). Both are at most EDIT_LONGEST long. */
static inline size_t edit_distance(const char *a, const char *b)
{
    size_t rows[3][EDIT_LONGEST + 1], m = strlen(a), n = strlen(b);
    size_t *before = rows[0], *last = rows[1], *now = rows[2];
    for (size_t j = 0; j <= n; j++)
        last[j] = j;
    for (size_t i = 1; i <= m; i++) {
        now[0] = i;
        for (size_t j = 1; j <= n; j++) {
            now[j] = edit_least(last[j - 1] + (a[i - 1] != b[j - 1]), edit_least(last[j], now[j - 1]) + 1);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = edit_least(now[j], before[j - 2] + 1);
        }
        size_t *free_row = before;
        before = last, last = now, now = free_row;
    }
    return last[n];
}

/* Words that differ in more than a third of their letters are not alike. *distance is set if they are. */
static inline bool edit_alike(const char *a, const char *b, size_t *distance)
{
    size_t m = strlen(a), n = strlen(b);
    if (m > EDIT_LONGEST || n > EDIT_LONGEST)
        return false;
    size_t d = edit_distance(a, b);
    bool alike = 3 * d <= edit_least(m, n) + 1;
    if (alike)
        *distance = d;
    return alike;
}

/* The word that is most like `meant`, of those seen. Begin with {.meant = WORD}. */
struct edit_nearest {
    const char *meant, *best; /* best: NULL if none is alike */
    size_t distance;          /* of best */
};

static inline void edit_see(struct edit_nearest *n, const char *word)
{
    size_t d;
    if (edit_alike(n->meant, word, &d) && (!n->best || d < n->distance))
        n->best = word, n->distance = d;
}
#endif
