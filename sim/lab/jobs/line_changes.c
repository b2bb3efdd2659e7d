/* line_changes.c - see line_changes.h. */
#include "lab/jobs/line_changes.h"
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "files/words.h"

/* How often a line of that length is in the text before `end`. */
static int count_of(const char *text, const char *end, const char *line, size_t length)
{
    int count = 0;
    while (*text && text < end) {
        size_t n = strcspn(text, "\n");
        count += n == length && !memcmp(text, line, n);
        text += n + (text[n] == '\n');
    }
    return count;
}

static void append_missing(char **to, char sign, const char *text, const char *other)
{
    for (const char *line = text; *line;) {
        size_t n = strcspn(line, "\n");
        const char *next = line + n + (line[n] == '\n');
        int here = count_of(text, next, line, n), there = count_of(other, other + strlen(other), line, n);
        if (here > there)
            words_append(to, "%c %.*s\n", sign, (int)n, line);
        line = next;
    }
}

char *line_changes(const char *old, const char *new)
{
    char *changes = xstrdup("");
    append_missing(&changes, '-', old, new);
    append_missing(&changes, '+', new, old);
    if (!*changes)
        words_append(&changes, "the lines shown are the same, in another order\n");
    return changes;
}
