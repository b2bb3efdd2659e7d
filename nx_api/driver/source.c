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
        s.lines[s.count] = (struct line){fixed ? without_tab(read) : text("%s", read), s.count + 1, false};
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
        s->lines[i].changed = false;
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

/* A statement: the lines it is in, its text in one piece, and the same with its texts in quotes made
 * invisible. */
struct statement {
    size_t first, last;
    char *text, *code;
    size_t count, size;
    struct place {
        size_t line, column; /* from 0 */
    } * places;
};

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
        append(st, c, quoted ? '"' : c, (struct place){i, k});
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

static void forget(struct statement *st)
{
    free(st->text);
    free(st->code);
    free(st->places);
}

/* --- comparisons: operands of logical type are names, elements, calls, constants, or in parentheses --- */

struct comparison {
    size_t left, op, length, right; /* right: behind the second operand */
    bool equal;
};

static bool in_name(char c)
{
    return isalnum((unsigned char)c) || c == '_' || c == '$' || c == '%';
}

/* Where the operand begins that ends before `end`. */
static size_t operand_before(const char *code, size_t end)
{
    int depth = 0;
    size_t i = end;
    while (i > 0 && code[i - 1] == ' ')
        i--;
    if (i > 0 && code[i - 1] == '.') { /* .true. */
        for (i--; i > 0 && code[i - 1] != '.';)
            i--;
        return i > 0 ? i - 1 : 0;
    }
    if (i > 0 && code[i - 1] == ')')
        do {
            i--;
            depth += (code[i] == ')') - (code[i] == '(');
        } while (i > 0 && depth > 0);
    while (i > 0 && in_name(code[i - 1]))
        i--;
    return i;
}

/* Behind the operand that begins at or after i. */
static size_t operand_end(const char *code, size_t i)
{
    int depth = 0;
    i += strspn(code + i, " ");
    if (code[i] == '.') {
        i += 1 + strcspn(code + i + 1, ".");
        return code[i] ? i + 1 : i;
    }
    while (in_name(code[i]))
        i++;
    size_t open = i + strspn(code + i, " ");
    if (code[open] != '(')
        return i;
    for (i = open; code[i]; i++) {
        depth += (code[i] == '(') - (code[i] == ')');
        if (depth == 0)
            return i + 1;
    }
    return i;
}

static bool find_comparison(const char *code, size_t *from, struct comparison *c)
{
    static const struct {
        const char *op;
        bool equal;
    } ops[] = {{".eq.", true}, {".ne.", false}, {"==", true}, {"/=", false}};
    for (size_t i = *from; code[i]; i++)
        for (size_t k = 0; k < sizeof ops / sizeof *ops; k++) {
            size_t n = strlen(ops[k].op);
            if (strncasecmp(code + i, ops[k].op, n) != 0)
                continue;
            *c = (struct comparison){operand_before(code, i), i, n, operand_end(code, i + n), ops[k].equal};
            *from = i + n;
            return true;
        }
    return false;
}

/* The first character of an operand behind a place. */
static size_t operand_behind(const struct statement *st, size_t line, size_t column)
{
    size_t i = 0;
    while (i < st->count &&
           (st->places[i].line < line || (st->places[i].line == line && st->places[i].column < column) ||
            st->code[i] == ' '))
        i++;
    return i;
}

/* The compiler tells where the first operand begins or, behind .not., the second. */
static bool choose(const struct statement *st, size_t at, struct comparison *chosen)
{
    struct comparison c;
    for (size_t from = 0; find_comparison(st->code, &from, &c);)
        if (c.left == at) {
            *chosen = c;
            return true;
        }
    for (size_t from = 0; find_comparison(st->code, &from, &c);)
        if (c.op + c.length + strspn(st->code + c.op + c.length, " ") == at) {
            *chosen = c;
            return true;
        }
    return false;
}

/* --- rewriting --- */

/* Takes the place of the statement's lines: as many as it needs. */
static void replace(struct source *s, const struct statement *st, const char *new)
{
    size_t room = s->fixed ? s->width - LABEL : strlen(new), n = strlen(new),
           needed = n > 0 ? (n + room - 1) / room : 1;
    size_t before = st->last - st->first + 1, origin = s->lines[st->first].origin;
    char label[LABEL + 1];
    snprintf(label, sizeof label, "%-*.*s", LABEL, LABEL, s->lines[st->first].text);
    struct line *lines = calloc(s->count + needed - before, sizeof *lines);
    if (!lines)
        fail("out of memory");
    memcpy(lines, s->lines, st->first * sizeof *lines);
    memcpy(lines + st->first + needed, s->lines + st->last + 1, (s->count - st->last - 1) * sizeof *lines);
    for (size_t i = 0; i < needed; i++)
        lines[st->first + i] = (struct line){text("%s%.*s",
                                                  !s->fixed ? ""
                                                  : i == 0  ? label
                                                            : "     &",
                                                  (int)room, new + i *room),
                                             origin + (i < before ? i : before - 1), true};
    s->lines = lines, s->count += needed - before;
}

bool source_compare_logicals(struct source *s, size_t line, size_t column)
{
    struct comparison c;
    if (line < 1 || line > s->count)
        return false;
    struct statement st = statement_at(s, line - 1);
    bool found =
        st.count > 0 && !s->lines[st.first].changed && choose(&st, operand_behind(&st, line - 1, column), &c);
    if (found) {
        size_t right = c.op + c.length;
        char *new =
            text("%.*s(%.*s%s%.*s)%s", (int)c.left, st.text, (int)(c.op - c.left), st.text + c.left,
                 c.equal ? ".eqv." : ".neqv.", (int)(c.right - right), st.text + right, st.text + c.right);
        replace(s, &st, new);
        free(new);
    }
    forget(&st);
    return found;
}
