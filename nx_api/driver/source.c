/* source.c - see source.h. */
#include "nx_api/driver/source.h"
#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "nx_api/driver/text.h"

enum { LABEL = 6 }; /* columns before a statement of fixed form */

/* --- reading and writing --- */

/* A tab in the first columns stands for blanks up to the statement, or to the mark of a continuation. */
static char *without_tab(const char *s)
{
    size_t n = strcspn(s, "\t");
    if (n >= LABEL || s[n] != '\t')
        return text("%s", s);
    bool continues = s[n + 1] >= '1' && s[n + 1] <= '9';
    return text("%-*.*s%s", LABEL - continues, (int)n, s, s + n + 1);
}

struct source source_read(const char *name, bool fixed, size_t width)
{
    struct source s = {.name = name, .fixed = fixed, .width = width};
    FILE *f = fopen(name, "r");
    char *read = NULL;
    size_t size = 0;
    if (!f)
        fail("%s: %s", name, strerror(errno));
    while (getline(&read, &size, f) >= 0) {
        read[strcspn(read, "\r\n")] = '\0';
        s.lines = reallocarray(s.lines, s.count + 1, sizeof *s.lines);
        if (!s.lines)
            fail("out of memory");
        s.lines[s.count] = (struct line){fixed ? without_tab(read) : text("%s", read), s.count + 1, 0};
        s.count++;
    }
    free(read);
    fclose(f);
    return s;
}

void source_write(const struct source *s, const char *path, bool marked)
{
    FILE *f = fopen(path, "w");
    if (!f)
        fail("%s: %s", path, strerror(errno));
    for (size_t i = 0; i < s->count; i++) {
        if (marked && (i == 0 || s->lines[i].origin != s->lines[i - 1].origin + 1))
            fprintf(f, "# %zu \"%s\"\n", s->lines[i].origin, s->name);
        fprintf(f, "%s\n", s->lines[i].text);
    }
    if (fclose(f))
        fail("%s: %s", path, strerror(errno));
}

void source_settle(struct source *s)
{
    for (size_t i = 0; i < s->count; i++)
        s->lines[i].settled = i + 1;
}

/* --- statements --- */

static bool is_comment(const char *s)
{
    return strchr("cC*dD!#", s[0]) || s[strspn(s, " \t")] == '\0' || s[strspn(s, " \t")] == '!';
}

static bool continues(const struct source *s, size_t i)
{
    const char *line = s->lines[i].text;
    return s->fixed && !is_comment(line) && strlen(line) > LABEL - 1 && line[LABEL - 1] != ' ' &&
           line[LABEL - 1] != '0';
}

static void append(struct statement *st, char c, char code, struct place place)
{
    if (st->count + 1 >= st->size) {
        st->size = 2 * st->size + 200;
        st->text = realloc(st->text, st->size);
        st->code = realloc(st->code, st->size);
        st->places = reallocarray(st->places, st->size, sizeof *st->places);
        if (!st->text || !st->code || !st->places)
            fail("out of memory");
    }
    st->text[st->count] = c, st->code[st->count] = code, st->places[st->count] = place;
    st->text[++st->count] = '\0', st->code[st->count] = '\0';
}

/* quote: that of the text which the line begins in, or 0. */
static void append_line(const struct source *s, struct statement *st, size_t i, char *quote)
{
    const char *line = s->lines[i].text;
    size_t n = strlen(line), begin = s->fixed ? LABEL : 0, end = s->fixed && i < st->last ? s->width : n;
    for (size_t k = begin; k < end && k < s->width; k++) {
        char c = k < n ? line[k] : ' ';
        bool quoted = *quote || c == '\'' || c == '"';
        if (*quote == c)
            *quote = 0;
        else if (!*quote && quoted)
            *quote = c;
        else if (!*quote && c == '!')
            break;
        append(st, c, quoted ? '"' : c, (struct place){s->lines[i].settled, k});
    }
}

static struct statement statement_at(const struct source *s, size_t i)
{
    struct statement st = {.first = i, .last = i};
    char quote = 0;
    while (s->fixed && st.first > 0 && (continues(s, st.first) || is_comment(s->lines[st.first].text)))
        st.first--;
    for (size_t k = i + 1; s->fixed && k < s->count; k++) {
        if (continues(s, k))
            st.last = k;
        else if (!is_comment(s->lines[k].text))
            break;
    }
    for (size_t k = st.first; k <= st.last; k++)
        if (k == st.first || !s->fixed || continues(s, k))
            append_line(s, &st, k, &quote);
    return st;
}

void statement_forget(struct statement *st)
{
    free(st->text);
    free(st->code);
    free(st->places);
}

bool source_statement(const struct source *s, size_t line, struct statement *st)
{
    size_t i = 0;
    while (i < s->count && s->lines[i].settled != line)
        i++;
    if (i == s->count)
        return false;
    *st = statement_at(s, i);
    if (st->count > 0)
        return true;
    statement_forget(st);
    return false;
}

size_t statement_behind(const struct statement *st, size_t line, size_t column)
{
    size_t i = 0;
    while (i < st->count &&
           (st->places[i].line < line || (st->places[i].line == line && st->places[i].column < column)))
        i++;
    return i;
}

/* --- rewriting --- */

/* Adds a statement of n characters to lines, of which there are *count, and more lines where it is too
 * long for one. */
static struct line *append_statement(const struct source *s, struct line *lines, size_t *count,
                                     const char *label, const char *new, size_t n)
{
    size_t room = s->fixed ? s->width - LABEL : n + 1, done = 0;
    do {
        lines = reallocarray(lines, *count + 1, sizeof *lines);
        if (!lines)
            fail("out of memory");
        size_t part = n - done < room ? n - done : room;
        const char *margin = !s->fixed ? "" : done == 0 ? label : "     &";
        lines[(*count)++] = (struct line){text("%s%.*s", margin, (int)part, new + done), 0, 0};
        done += part;
    } while (done < n);
    return lines;
}

void source_replace(struct source *s, const struct statement *st, const char *new)
{
    char label[LABEL + 1];
    size_t count = st->first, before = st->last - st->first + 1, origin = s->lines[st->first].origin;
    size_t behind = s->count - st->last - 1;
    struct line *lines = calloc(count + 1, sizeof *lines);
    if (!lines)
        fail("out of memory");
    memcpy(lines, s->lines, count * sizeof *lines);
    snprintf(label, sizeof label, "%-*.*s", LABEL, LABEL, s->lines[st->first].text);
    for (const char *at = new; at; at = strchr(at, '\n') ? strchr(at, '\n') + 1 : NULL) {
        lines = append_statement(s, lines, &count, label, at, strcspn(at, "\n"));
        memset(label, ' ', LABEL);
    }
    for (size_t i = st->first; i < count; i++)
        lines[i].origin = origin + (i - st->first < before ? i - st->first : before - 1);
    lines = reallocarray(lines, count + behind + 1, sizeof *lines);
    if (!lines)
        fail("out of memory");
    memcpy(lines + count, s->lines + st->last + 1, behind * sizeof *lines);
    s->lines = lines, s->count = count + behind;
}
