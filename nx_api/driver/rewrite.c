/* rewrite.c - see rewrite.h. Each rule below is for one kind of message. */
#include "nx_api/driver/rewrite.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "nx_api/driver/text.h"

/* --- parts of a statement --- */

static bool in_name(char c)
{
    return isalnum((unsigned char)c) || c == '_' || c == '$' || c == '%';
}

static size_t skip_blanks(const char *code, size_t i)
{
    return i + strspn(code + i, " ");
}

/* The parenthesis that closes the one at `open`, or the statement's end. */
static size_t closing(const char *code, size_t open)
{
    int depth = 0;
    for (size_t i = open; code[i]; i++) {
        depth += (code[i] == '(') - (code[i] == ')');
        if (depth == 0)
            return i;
    }
    return strlen(code);
}

/* The end of the argument that begins at i, at a comma or at `close`. */
static size_t argument_end(const char *code, size_t i, size_t close)
{
    while (i < close && code[i] != ',')
        i = code[i] == '(' ? closing(code, i) + 1 : i + 1;
    return i < close ? i : close;
}

static bool is_word(const char *code, size_t i, const char *word)
{
    size_t n = strlen(word);
    return !strncasecmp(code + i, word, n) && !in_name(code[i + n]);
}

/* Where the action of a logical IF begins, or the statement itself. */
static size_t action(const char *code)
{
    size_t i = skip_blanks(code, 0), open = skip_blanks(code, i + 2);
    if (!is_word(code, i, "if") || code[open] != '(')
        return i;
    size_t close = closing(code, open);
    return code[close] ? skip_blanks(code, close + 1) : i;
}

/* --- comparisons: operands of logical type are names, elements, calls, constants, or in parentheses --- */

struct comparison {
    size_t left, op, length, right; /* right: behind the second operand */
    bool equal;
};

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
    i = skip_blanks(code, i);
    if (code[i] == '.') {
        i += 1 + strcspn(code + i + 1, ".");
        return code[i] ? i + 1 : i;
    }
    while (in_name(code[i]))
        i++;
    size_t open = skip_blanks(code, i);
    if (code[open] != '(')
        return i;
    i = closing(code, open);
    return code[i] ? i + 1 : i;
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
        if (skip_blanks(st->code, c.op + c.length) == at) {
            *chosen = c;
            return true;
        }
    return false;
}

static char *logicals_compared(const struct statement *st, size_t at, enum truth truth)
{
    struct comparison c;
    (void)truth;
    if (!choose(st, skip_blanks(st->code, at), &c))
        return NULL;
    size_t right = c.op + c.length;
    return text("%.*s(%.*s%s%.*s)%s", (int)c.left, st->text, (int)(c.op - c.left), st->text + c.left,
                c.equal ? ".eqv." : ".neqv.", (int)(c.right - right), st->text + right, st->text + c.right);
}

/* A number compared with a text, in apostrophes, becomes one compared with a Hollerith constant. */
static char *text_compared(const struct statement *st, size_t at, enum truth truth)
{
    struct comparison c;
    (void)truth;
    if (!choose(st, skip_blanks(st->code, at), &c))
        return NULL;
    size_t begin = skip_blanks(st->code, c.op + c.length), end = begin + strspn(st->code + begin, "\"");
    if (end < begin + 2 || memchr(st->text + begin + 1, st->text[begin], end - begin - 2))
        return NULL;
    return text("%.*s%zuh%.*s%s", (int)begin, st->text, end - begin - 2, (int)(end - begin - 2),
                st->text + begin + 1, st->text + end);
}

/* --- numbers as conditions, of IF, ELSE IF and DO WHILE --- */

static char *condition(const struct statement *st, size_t at, enum truth truth)
{
    size_t open = strcspn(st->code, "("), close = closing(st->code, open);
    (void)at;
    if (!st->code[close])
        return NULL;
    return text("%.*s(%s%.*s%s)%s", (int)open, st->text, truth == ODD ? "btest(" : "(",
                (int)(close - open - 1), st->text + open + 1, truth == ODD ? ", 0)" : ") .ne. 0",
                st->text + close + 1);
}

/* --- statements that are not there --- */

/* ENCODE and DECODE (count, format, buffer, ...) list, below an IF or not: the buffer has any type, so a
 * Cray pointer makes a text of it. */
static char *in_memory(const struct statement *st, size_t begin, const char *verb)
{
    const char *t = st->text;
    bool below = begin > skip_blanks(st->code, 0);
    size_t open = begin + strcspn(st->code + begin, "("), close = closing(st->code, open);
    size_t format = argument_end(st->code, open + 1, close),
           buffer = argument_end(st->code, format + 1, close);
    size_t more = argument_end(st->code, buffer + 1, close);
    if (buffer >= close || !st->code[close])
        return NULL;
    return text(
        "%.*s%sblock\ncharacter*10000000 nxcc_text\npointer (nxcc_at, nxcc_text)\nnxcc_at = loc(%.*s)\n"
        "%s (nxcc_text(1:%.*s)%.*s%.*s)%s\nend block%s",
        (int)begin, t, below ? "then\n" : "", (int)(more - buffer - 1), t + buffer + 1, verb,
        (int)(format - open - 1), t + open + 1, (int)(buffer - format), t + format, (int)(close - more),
        t + more, t + close + 1, below ? "\nend if" : "");
}

static char *unknown_statement(const struct statement *st, size_t at, enum truth truth)
{
    static const struct {
        const char *old, *new;
        bool whole; /* new stands for all of the statement */
    } words[] = {{"accept", "read", false},
                 {"virtual", "dimension", false},
                 {"find", "continue", true},
                 {"options", "", true}};
    size_t begin = action(st->code);
    (void)at, (void)truth;
    if (is_word(st->code, begin, "encode"))
        return in_memory(st, begin, "write");
    if (is_word(st->code, begin, "decode"))
        return in_memory(st, begin, "read");
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (is_word(st->code, begin, words[i].old))
            return text("%.*s%s%s", (int)begin, st->text, words[i].new,
                        words[i].whole ? "" : st->text + begin + strlen(words[i].old));
    return NULL;
}

/* --- OPEN and CLOSE --- */

/* GNU Fortran's name for an argument, "" if it only made files faster and is left out, or NULL. */
static const char *new_keyword(const char *code, size_t i, bool opens)
{
    static const struct {
        const char *old, *new;
        bool opens;
    } keywords[] = {{"name", "file", true},    {"type", "status", true},    {"recordsize", "recl", true},
                    {"maxrec", "", true},      {"initialsize", "", true},   {"extendsize", "", true},
                    {"blocksize", "", true},   {"buffercount", "", true},   {"buffered", "", true},
                    {"disp", "status", false}, {"dispose", "status", false}};
    for (size_t k = 0; k < sizeof keywords / sizeof *keywords; k++)
        if (keywords[k].opens == opens && is_word(code, i, keywords[k].old))
            return keywords[k].new;
    return NULL;
}

static char *file_keywords(const struct statement *st, size_t at, enum truth truth)
{
    size_t begin = action(st->code), open = begin + strcspn(st->code + begin, "("),
           close = closing(st->code, open);
    bool any = false;
    char *new = text("%.*s", (int)(open + 1), st->text);
    (void)at, (void)truth;
    for (size_t i = open + 1, end; i < close; i = end + 1) {
        end = argument_end(st->code, i, close);
        size_t equal = i + strcspn(st->code + i, "=");
        const char *known =
            equal < end ? new_keyword(st->code, skip_blanks(st->code, i), is_word(st->code, begin, "open"))
                        : NULL;
        const char *comma = new[strlen(new) - 1] == '(' ? "" : ",";
        any = any || known;
        if (!known)
            new = text("%s%s%.*s", new, comma, (int)(end - i), st->text + i);
        else if (*known)
            new = text("%s%s %s%.*s", new, comma, known, (int)(end - equal), st->text + equal);
    }
    return any ? text("%s%s", new, st->text + close) : NULL;
}

/* --- READ and WRITE (unit'record ...): REC= has to come last. What is behind the apostrophe looks like a
 * text. --- */

static char *record_number(const struct statement *st, size_t at, enum truth truth)
{
    const char *t = st->text;
    size_t begin = action(st->code), open = begin + strcspn(t + begin, "("),
           mark = open + strcspn(t + open, "',)");
    (void)at, (void)truth;
    if (t[mark] != '\'')
        return NULL;
    size_t close = closing(t, open), end = argument_end(t, mark + 1, close);
    return text("%.*s%.*s, rec=%.*s%s", (int)mark, t, (int)(close - end), t + end, (int)(end - mark - 1),
                t + mark + 1, t + close);
}

/* --- EXTERNAL with a routine's own name, which ends where the compiler complains --- */

static char *own_name(const struct statement *st, size_t at, enum truth truth)
{
    size_t begin = at, end = skip_blanks(st->code, at);
    (void)truth;
    while (begin > 0 && in_name(st->code[begin - 1]))
        begin--;
    if (st->code[end] == ',')
        return text("%.*s%s", (int)begin, st->text, st->text + end + 1);
    while (begin > 0 && st->code[begin - 1] == ' ')
        begin--;
    return begin > 0 && st->code[begin - 1] == ',' ? text("%.*s%s", (int)begin - 1, st->text, st->text + end)
                                                   : text("%s", "");
}

rewriting *rewriting_for(const char *message)
{
    static const struct {
        const char *says;
        rewriting *rule;
    } rules[] = {
        {"Logicals at (1) must be compared with", logicals_compared},
        {"Operands of comparison operator", text_compared},
        {"IF clause at (1) requires a scalar LOGICAL", condition},
        {"DO WHILE loop at (1) must be a scalar LOGICAL", condition},
        {"Unclassifiable statement at (1)", unknown_statement},
        {"Syntax error in IF-clause after (1)", unknown_statement},
        {"Syntax error in OPEN statement", file_keywords},
        {"Syntax error in CLOSE statement", file_keywords},
        {"Syntax error in READ statement", record_number},
        {"Syntax error in WRITE statement", record_number},
        {"EXTERNAL attribute conflicts with", own_name},
    };
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++)
        if (strstr(message, rules[i].says))
            return rules[i].rule;
    return NULL;
}
