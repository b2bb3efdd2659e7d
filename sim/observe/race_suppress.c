/* race_suppress.c - see race_suppress.h. */
#include "observe/race_suppress.h"
#include <fnmatch.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "files/text_file.h"
#include "kernel/xalloc.h"

enum what { FILE_LINE, VARIABLE, FUNCTION, WHATS };
static const char *const NAMES[WHATS] = {"file", "variable", "function"};
enum { LARGEST = 1 << 20 };

struct one {
    enum what what;
    char *pattern;
};

struct race_suppressions {
    struct one *list;
    size_t count;
};

void race_suppress_free(struct race_suppressions *s)
{
    if (!s)
        return;
    for (size_t i = 0; i < s->count; i++)
        free(s->list[i].pattern);
    free(s->list);
    free(s);
}

/* What a line says: *what and its pattern, malloc'd. False: it says neither this nor nothing. */
static bool read_line(const char *line, enum what *what, char **pattern)
{
    char word[32], rest[256], more;
    *pattern = NULL;
    int parts = sscanf(line, "%31s %255s %c", word, rest, &more);
    if (parts < 1)
        return true;
    for (int i = 0; i < WHATS && parts == 2; i++)
        if (strcmp(word, NAMES[i]) == 0) {
            *what = (enum what)i;
            *pattern = xstrdup(rest);
            return true;
        }
    return false;
}

static bool read_lines(struct race_suppressions *s, char *text, const char *path, char **error)
{
    int number = 1;
    for (char *line = text, *next; line; line = next, number++) {
        next = strchr(line, '\n');
        if (next)
            *next++ = '\0';
        line[strcspn(line, "#")] = '\0';
        struct one one;
        if (!read_line(line, &one.what, &one.pattern)) {
            *error = xasprintf("%s:%d: a line is 'file NAME:LINE', 'file NAME', 'variable NAME' or 'function "
                               "NAME', where * and ? stand for any letters",
                               path, number);
            return false;
        }
        if (!one.pattern)
            continue;
        s->list = xreallocarray(s->list, s->count + 1, sizeof *s->list);
        s->list[s->count++] = one;
    }
    return true;
}

struct race_suppressions *race_suppress_read(const char *path, char **error)
{
    const char *why;
    int line;
    char *text = text_file_read(path, LARGEST, &why, &line);
    if (!text) {
        *error = line ? xasprintf("%s:%d: %s", path, line, why) : xasprintf("%s: %s", path, why);
        return NULL;
    }
    struct race_suppressions *s = xcalloc(1, sizeof *s);
    bool good = read_lines(s, text, path, error);
    free(text);
    if (good)
        return s;
    race_suppress_free(s);
    return NULL;
}

/* A name matches itself, also one with brackets, which a pattern takes for letters to choose from. */
static bool matches(const char *pattern, const char *name)
{
    return strcmp(pattern, name) == 0 || fnmatch(pattern, name, 0) == 0;
}

static bool is_in_line(const char *pattern, const struct race_frame *f)
{
    char *line = xasprintf("%s:%d", f->file, f->line);
    bool is = matches(pattern, line) || matches(pattern, f->file);
    free(line);
    return is;
}

static bool matches_side(const struct one *one, const struct race_report_side *s)
{
    if (one->what == FILE_LINE)
        return is_in_line(one->pattern, &s->frames[0]);
    for (size_t i = 0; i < s->depth && one->what == FUNCTION; i++)
        if (matches(one->pattern, s->frames[i].function))
            return true;
    return false;
}

bool race_suppress_matches(const struct race_suppressions *s, const struct race_report *r)
{
    for (size_t i = 0; s && i < s->count; i++) {
        const struct one *one = &s->list[i];
        if (one->what == VARIABLE && matches(one->pattern, r->variable))
            return true;
        if (matches_side(one, &r->side[0]) || matches_side(one, &r->side[1]))
            return true;
    }
    return false;
}
