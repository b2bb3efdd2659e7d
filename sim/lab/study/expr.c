/* expr.c - see expr.h. A recursive-descent parser builds a tree whose nodes (parts) lie in one array. */
#include "lab/study/expr.h"
#include "kernel/xalloc.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum kind {
    NUMBER,
    NAME,
    TEXT, /* leaves */
    NOT,
    MINUS,
    OR,
    AND,
    LESS,
    NOT_MORE,
    EQUAL,
    NOT_EQUAL,
    NOT_LESS,
    MORE,
    SAME_TEXT,
    OTHER_TEXT,
    ADD,
    SUBTRACT,
    MULTIPLY,
    DIVIDE,
    REMAINDER,
    POWER,
    MIN,
    MAX,
    FLOOR,
    CEIL,
    ROUND,
    SQRT,
    LOG2,
    ABS,
    IF,
};

struct part {
    enum kind kind;
    short at[3]; /* operands: indices in the array */
    short name;  /* NAME: its index among the names */
    bool is_text;
    double number; /* NUMBER */
    char *text;    /* TEXT */
};

enum { MAX_PARTS = 256, MAX_WORD = 64, MAX_LIST = 256, MAX_DEPTH = 64 };

struct expr {
    char *text;
    short root;
    short count;
    struct part part[MAX_PARTS];
};

struct reader {
    struct expr *e;
    const struct expr_name *names;
    size_t name_count;
    const char *at;
    int depth;
    char *why; /* the first error */
};

static short fail(struct reader *r, char *why)
{
    if (r->why)
        free(why);
    else
        r->why = why;
    return -1;
}

static short make(struct reader *r, struct part part)
{
    if (r->e->count == MAX_PARTS) {
        free(part.text);
        return fail(r, xasprintf("is too long: %d names, numbers and signs are allowed", MAX_PARTS));
    }
    r->e->part[r->e->count] = part;
    return r->e->count++;
}

static bool is_text(const struct reader *r, short at)
{
    return at >= 0 && r->e->part[at].is_text;
}

/* Skips the sign if it is next. False if it is not. */
static bool take(struct reader *r, const char *sign)
{
    r->at += strspn(r->at, " \t\n");
    size_t n = strlen(sign);
    if (strncmp(r->at, sign, n) != 0)
        return false;
    r->at += n;
    return true;
}

/* All known names: "nodes, group"; malloc'd. */
static char *list_of_names(const struct reader *r)
{
    char list[MAX_LIST] = "";
    for (size_t i = 0, used = 0; i < r->name_count && used < sizeof list; i++)
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", r->names[i].name);
    return xstrdup(list);
}

static short no_such_name(struct reader *r, const char *word)
{
    if (!r->name_count)
        return fail(r, xasprintf("there is no axis %s before this one", word));
    char *list = list_of_names(r);
    short failed = fail(r, xasprintf("there is no axis %s; there are: %s", word, list));
    free(list);
    return failed;
}

/* Fails if the part is a text: a number is needed. */
static short need_number(struct reader *r, short at)
{
    if (!is_text(r, at))
        return at;
    const struct part *p = &r->e->part[at];
    if (p->kind == TEXT)
        return no_such_name(r, p->text);
    return fail(r, xasprintf("%s is no number or axis of numbers: only = and != are allowed",
                             r->names[p->name].name));
}

/* --- leaves --------------------------------------------------------------------------------------------- */

static short alternative(struct reader *r);

static const struct {
    const char *name;
    enum kind kind;
    int count;
} FUNCTIONS[] = {{"min", MIN, 2},   {"max", MAX, 2},     {"floor", FLOOR, 1},
                 {"ceil", CEIL, 1}, {"round", ROUND, 1}, {"sqrt", SQRT, 1},
                 {"log2", LOG2, 1}, {"abs", ABS, 1},     {"if", IF, 3}};
enum { FUNCTION_COUNT = sizeof FUNCTIONS / sizeof *FUNCTIONS };

/* Reads a function's arguments, after its name and "(". */
static short arguments(struct reader *r, size_t function)
{
    struct part p = {.kind = FUNCTIONS[function].kind, .at = {-1, -1, -1}};
    for (int i = 0; i < FUNCTIONS[function].count; i++) {
        if (i && !take(r, ","))
            return fail(r, xasprintf("%s needs %d values, with commas between", FUNCTIONS[function].name,
                                     FUNCTIONS[function].count));
        if ((p.at[i] = need_number(r, alternative(r))) < 0)
            return -1;
    }
    return take(r, ")") ? make(r, p) : fail(r, xasprintf(") is missing at \"%s\"", r->at));
}

static short name_of(const struct reader *r, const char *word)
{
    for (size_t i = 0; i < r->name_count; i++)
        if (strcmp(r->names[i].name, word) == 0)
            return (short)i;
    return -1;
}

/* A name, a function, or a text without quotes. */
static short word(struct reader *r)
{
    char text[MAX_WORD];
    size_t n = strspn(r->at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.-");
    size_t plain = strspn(r->at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.");
    /* Tries the longest name first: a minus may belong to a name or be the sign. */
    for (size_t size = n < MAX_WORD ? n : MAX_WORD - 1; size > 0; size--) {
        snprintf(text, sizeof text, "%.*s", (int)size, r->at);
        short name = size == n || r->at[size] == '-' ? name_of(r, text) : -1;
        if (name < 0)
            continue;
        r->at += size;
        return make(r, (struct part){.kind = NAME, .name = name, .is_text = !r->names[name].numeric});
    }
    snprintf(text, sizeof text, "%.*s", (int)plain, r->at);
    r->at += plain;
    for (size_t i = 0; i < FUNCTION_COUNT; i++)
        if (strcmp(FUNCTIONS[i].name, text) == 0 && take(r, "("))
            return arguments(r, i);
    return make(r, (struct part){.kind = TEXT, .text = xstrdup(text), .is_text = true});
}

static short quoted(struct reader *r)
{
    const char *end = strchr(r->at, '\'');
    if (!end)
        return fail(r, xasprintf("' is missing after %s", r->at));
    char *text = xasprintf("%.*s", (int)(end - r->at), r->at);
    r->at = end + 1;
    return make(r, (struct part){.kind = TEXT, .text = text, .is_text = true});
}

static short leaf(struct reader *r)
{
    if (take(r, "(")) {
        short inner = alternative(r);
        return inner < 0 || take(r, ")") ? inner : fail(r, xasprintf(") is missing at \"%s\"", r->at));
    }
    if (take(r, "'"))
        return quoted(r);
    if (isalpha((unsigned char)*r->at) || *r->at == '_')
        return word(r);
    if (isdigit((unsigned char)*r->at) || *r->at == '.') {
        char *end;
        double number = strtod(r->at, &end);
        if (end > r->at && isfinite(number)) {
            r->at = end;
            return make(r, (struct part){.kind = NUMBER, .number = number});
        }
    }
    return fail(r, *r->at ? xasprintf("\"%s\" is neither a number, a name nor '('", r->at)
                          : xasprintf("something is missing at the end of \"%s\"", r->e->text));
}

/* --- signs, by how they bind ---------------------------------------------------------------------------- */

static short factor(struct reader *r)
{
    short inner;
    bool minus = take(r, "-"), not = !minus && take(r, "!");
    if (++r->depth > MAX_DEPTH)
        return fail(r, xasprintf("is nested more than %d deep", MAX_DEPTH));
    if (minus || not ) {
        if ((inner = need_number(r, factor(r))) >= 0)
            inner = make(r, (struct part){.kind = minus ? MINUS : NOT, .at = {inner}});
    } else if ((inner = leaf(r)) >= 0 && take(r, "^")) {
        short base = need_number(r, inner), power = base < 0 ? -1 : need_number(r, factor(r));
        inner = power < 0 ? -1 : make(r, (struct part){.kind = POWER, .at = {base, power}});
    }
    r->depth--;
    return inner;
}

/* Fails unless text is one of the name's values. */
static short check_text(struct reader *r, short name, const char *text)
{
    const struct expr_name *n = &r->names[r->e->part[name].name];
    const char *one;
    char list[MAX_LIST] = "";
    for (size_t i = 0, used = 0; (one = n->text(n->arg, i)); i++) {
        if (strcmp(one, text) == 0)
            return 0;
        if (used < sizeof list)
            used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", one);
    }
    return fail(
        r, xasprintf("%s is neither an axis nor a value of %s; its values are: %s", text, n->name, list));
}

/* Reads = or != between texts, or between a text and a name. */
static short compare_texts(struct reader *r, enum kind kind, short left, short right)
{
    for (int side = 0; side < 2; side++) {
        short name = side ? right : left, other = side ? left : right;
        const struct part *p = &r->e->part[name];
        if (p->kind != NAME || !p->is_text)
            continue;
        struct part *o = &r->e->part[other];
        if (o->kind == NUMBER) /* a text that looks like a number */
            *o = (struct part){.kind = TEXT, .is_text = true, .text = xasprintf("%.15g", o->number)};
        if (!o->is_text)
            return need_number(r, name);
        if (o->kind == TEXT && check_text(r, name, o->text) < 0)
            return -1;
        return make(r, (struct part){.kind = kind == EQUAL ? SAME_TEXT : OTHER_TEXT, .at = {left, right}});
    }
    return need_number(r, is_text(r, left) ? left : right);
}

static const struct {
    const char *sign;
    enum kind kind;
    int level;
} SIGNS[] = {{"||", OR, 0},    {"&&", AND, 1},     {"<=", NOT_MORE, 2},  {"<", LESS, 2},
             {"==", EQUAL, 2}, {"=", EQUAL, 2},    {"!=", NOT_EQUAL, 2}, {">=", NOT_LESS, 2},
             {">", MORE, 2},   {"+", ADD, 3},      {"-", SUBTRACT, 3},   {"*", MULTIPLY, 4},
             {"/", DIVIDE, 4}, {"%", REMAINDER, 4}};
enum { SIGN_COUNT = sizeof SIGNS / sizeof *SIGNS, COMPARING = 2, LEVELS = 5 };

static bool take_sign(struct reader *r, int level, enum kind *kind)
{
    for (size_t i = 0; i < SIGN_COUNT; i++)
        if (SIGNS[i].level == level && take(r, SIGNS[i].sign)) {
            *kind = SIGNS[i].kind;
            return true;
        }
    return false;
}

static short join(struct reader *r, enum kind kind, short left, short right)
{
    if ((kind == EQUAL || kind == NOT_EQUAL) && (is_text(r, left) || is_text(r, right)))
        return compare_texts(r, kind, left, right);
    if (need_number(r, left) < 0 || need_number(r, right) < 0)
        return -1;
    return make(r, (struct part){.kind = kind, .at = {left, right}});
}

static short at_level(struct reader *r, int level)
{
    if (level == LEVELS)
        return factor(r);
    short left = at_level(r, level + 1);
    for (enum kind kind; left >= 0 && take_sign(r, level, &kind);) {
        short right = at_level(r, level + 1);
        left = right < 0 ? -1 : join(r, kind, left, right);
        if (level == COMPARING && left >= 0 && take_sign(r, level, &kind))
            return fail(
                r, xasprintf("compares twice at \"%s\": join comparisons by &&", r->at + strspn(r->at, " ")));
    }
    return left;
}

static short alternative(struct reader *r)
{
    if (++r->depth > MAX_DEPTH)
        return fail(r, xasprintf("is nested more than %d deep", MAX_DEPTH));
    short all = at_level(r, 0);
    r->depth--;
    return all;
}

struct expr *expr_read(const char *text, const struct expr_name names[], size_t count, char **why)
{
    struct expr *e = xcalloc(1, sizeof *e);
    e->text = xstrdup(text);
    struct reader r = {.e = e, .names = names, .name_count = count, .at = e->text};
    e->root = need_number(&r, alternative(&r));
    r.at += strspn(r.at, " \t\n");
    if (e->root >= 0 && *r.at)
        e->root = fail(&r, xasprintf("\"%s\" is not expected in \"%s\"", r.at, text));
    if (e->root >= 0)
        return e;
    *why = r.why;
    expr_free(e);
    return NULL;
}

void expr_free(struct expr *e)
{
    if (!e)
        return;
    for (short i = 0; i < e->count; i++)
        free(e->part[i].text);
    free(e->text);
    free(e);
}

/* --- what it comes to ----------------------------------------------------------------------------------- */

static const char *text_at(const struct part *p, const struct expr_value values[])
{
    return p->kind == TEXT ? p->text : values[p->name].text;
}

/* The value of an operation of one operand or two. */
static double applied(enum kind kind, double a, double b)
{
    switch (kind) {
    case NOT:
        return a == 0;
    case MINUS:
        return -a;
    case OR:
        return a != 0 || b != 0;
    case AND:
        return a != 0 && b != 0;
    case LESS:
        return a < b;
    case NOT_MORE:
        return a <= b;
    case EQUAL:
        return a == b;
    case NOT_EQUAL:
        return a != b;
    case NOT_LESS:
        return a >= b;
    case MORE:
        return a > b;
    case ADD:
        return a + b;
    case SUBTRACT:
        return a - b;
    case MULTIPLY:
        return a * b;
    case DIVIDE:
        return a / b;
    case REMAINDER:
        return fmod(a, b);
    case POWER:
        return pow(a, b);
    case MIN:
        return fmin(a, b);
    case MAX:
        return fmax(a, b);
    case FLOOR:
        return floor(a);
    case CEIL:
        return ceil(a);
    case ROUND:
        return round(a);
    case SQRT:
        return sqrt(a);
    case LOG2:
        return log2(a);
    case ABS:
        return fabs(a);
    default:
        return NAN;
    }
}

static double number_at(const struct expr *e, short at, const struct expr_value values[])
{
    const struct part *p = &e->part[at];
    if (p->kind == NUMBER)
        return p->number;
    if (p->kind == NAME)
        return values[p->name].number;
    if (p->kind == SAME_TEXT || p->kind == OTHER_TEXT)
        return (strcmp(text_at(&e->part[p->at[0]], values), text_at(&e->part[p->at[1]], values)) == 0) ==
               (p->kind == SAME_TEXT);
    double a = number_at(e, p->at[0], values);
    if (p->kind == IF)
        return number_at(e, p->at[a != 0 ? 1 : 2], values);
    double b = (p->kind >= OR && p->kind <= POWER) || p->kind == MIN || p->kind == MAX
                   ? number_at(e, p->at[1], values)
                   : 0;
    return applied(p->kind, a, b);
}

double expr_number(const struct expr *e, const struct expr_value values[])
{
    return number_at(e, e->root, values);
}

bool expr_uses(const struct expr *e, size_t i)
{
    for (short k = 0; k < e->count; k++)
        if (e->part[k].kind == NAME && (size_t)e->part[k].name == i)
            return true;
    return false;
}

const char *expr_text(const struct expr *e)
{
    return e->text;
}
