/* regcomp.c - the compiler of regular expressions: POSIX's basic and extended ones with GNU's additions (\+
 * \? \| in basic ones, \w \W \s \S \b \B \< \> in both). What is made lies in memory of the program's own.
 * Characters have one byte. */
#define _GNU_SOURCE
#include <ctype.h>
#include <limits.h>
#include <regex.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "regex_code.h"

enum { BEHIND_LOOK = 2 }; /* nothing repeats a look; and a ^ behind it is a character in a basic expression */
enum { MOST_TIMES = 0x7fff, MOST_STEPS = 1 << 20 };

struct parser {
    struct regex *r;
    const char *at; /* what is still to be read */
    int extended, depth;
    int begins;      /* a repetition here has nothing to repeat */
    unsigned closed; /* a bit for each group that a back reference may name */
    int error;
};

/* --- memory --- */

/* Room for one more element; count is a power of two whenever there is none. */
static int one_more(void **list, int count, size_t bytes)
{
    if (count & (count - 1))
        return 1;
    void *more = realloc(*list, (count ? 2 * (size_t)count : 1) * bytes);
    if (more)
        *list = more;
    return more != NULL;
}

static int fail(struct parser *p, int error)
{
    if (!p->error)
        p->error = error;
    return 0;
}

static int add_piece(struct parser *p, struct piece is)
{
    struct regex *r = p->r;
    void *list = r->pieces;
    if (!one_more(&list, r->piece_count, sizeof is))
        return fail(p, REG_ESPACE);
    r->pieces = list;
    r->pieces[r->piece_count] = is;
    return r->piece_count++;
}

/* The piece is made before the set is filled. */
static unsigned char *add_set(struct parser *p, int *piece)
{
    struct regex *r = p->r;
    void *list = r->sets;
    static unsigned char nowhere[32];
    *piece = add_piece(p, (struct piece){.kind = SET, .number = r->set_count});
    if (!one_more(&list, r->set_count, sizeof *r->sets)) {
        fail(p, REG_ESPACE);
        return nowhere;
    }
    r->sets = list;
    return memset(r->sets[r->set_count++], 0, sizeof *r->sets);
}

/* --- sets --- */

static void put(unsigned char *set, int c)
{
    set[c >> 3] |= (unsigned char)(1 << (c & 7));
}

static void put_class(unsigned char *set, int (*is_in)(int))
{
    for (int c = 0; c < 256; c++)
        if (is_in(c))
            put(set, c);
}

static int is_word(int c)
{
    return isalnum(c) || c == '_';
}

static void negate(unsigned char *set)
{
    for (int i = 0; i < 32; i++)
        set[i] = (unsigned char)~set[i];
}

static void without_newline(const struct parser *p, unsigned char *set)
{
    if (p->r->flags & REG_NEWLINE)
        set['\n' >> 3] &= (unsigned char)~(1 << ('\n' & 7));
}

static void both_cases(const struct parser *p, unsigned char *set)
{
    for (int c = 0; p->r->flags & REG_ICASE && c < 256; c++)
        if (set_has(set, c) && isalpha(c)) {
            put(set, toupper(c));
            put(set, tolower(c));
        }
}

static int one_character(struct parser *p, int c)
{
    int piece;
    unsigned char *set = add_set(p, &piece);
    put(set, c);
    both_cases(p, set);
    return piece;
}

static int of_class(struct parser *p, int (*is_in)(int), int others)
{
    int piece;
    unsigned char *set = add_set(p, &piece);
    put_class(set, is_in);
    if (others)
        negate(set);
    return piece;
}

static int any_character(struct parser *p)
{
    int piece;
    unsigned char *set = add_set(p, &piece);
    negate(set);
    without_newline(p, set);
    return piece;
}

/* --- sets in brackets --- */

static int (*class_named(const char *name, size_t length))(int)
{
    static const struct {
        const char *name;
        int (*is_in)(int);
    } classes[] = {{"alpha", isalpha}, {"digit", isdigit}, {"alnum", isalnum}, {"upper", isupper},
                   {"lower", islower}, {"space", isspace}, {"blank", isblank}, {"punct", ispunct},
                   {"print", isprint}, {"graph", isgraph}, {"cntrl", iscntrl}, {"xdigit", isxdigit}};
    for (size_t i = 0; i < sizeof classes / sizeof *classes; i++)
        if (strlen(classes[i].name) == length && !strncmp(classes[i].name, name, length))
            return classes[i].is_in;
    return NULL;
}

/* "[:alpha:]" without its first bracket, or what '.' and '=' enclose: a character, -1 if it was a class. */
static int read_enclosed(struct parser *p, unsigned char *set)
{
    char sign = *p->at, ends[3] = {sign, ']', 0};
    const char *name = p->at + 1, *end = strstr(name, ends);
    if (!end)
        return fail(p, REG_EBRACK);
    p->at = end + 2;
    if (sign != ':')
        return end == name + 1 ? (unsigned char)*name : fail(p, REG_ECOLLATE);
    int (*is_in)(int) = class_named(name, (size_t)(end - name));
    if (!is_in)
        return fail(p, REG_ECTYPE);
    put_class(set, is_in);
    return -1;
}

/* A character, or -1 if it was a class. */
static int read_element(struct parser *p, unsigned char *set)
{
    int c = (unsigned char)*p->at++;
    if (!c) {
        p->at--;
        return fail(p, REG_EBRACK);
    }
    return c == '[' && *p->at && strchr(":.=", *p->at) ? read_enclosed(p, set) : c;
}

static void read_range(struct parser *p, unsigned char *set)
{
    int from = read_element(p, set), to = from;
    if (p->at[0] == '-' && p->at[1] && p->at[1] != ']') {
        p->at++;
        to = read_element(p, set);
        if (!p->error && (from < 0 || to < from))
            fail(p, REG_ERANGE);
    }
    for (int c = from; from >= 0 && c <= to && !p->error; c++)
        put(set, c);
}

static int read_brackets(struct parser *p)
{
    int piece, others = *p->at == '^';
    unsigned char *set = add_set(p, &piece);
    p->at += others;
    do
        read_range(p, set);
    while (!p->error && *p->at != ']');
    p->at++;
    both_cases(p, set);
    if (others) {
        negate(set);
        without_newline(p, set);
    }
    return piece;
}

/* --- pieces --- */

static int is_escaped(const struct parser *p, char c)
{
    return p->at[0] == '\\' && p->at[1] == c;
}

/* Is the next one this operator? It has a backslash in one of the two kinds of expressions. */
static int is_operator(const struct parser *p, char c)
{
    return p->extended ? *p->at == c : is_escaped(p, c);
}

static int take_operator(struct parser *p, char c)
{
    int is = is_operator(p, c);
    if (is)
        p->at += p->extended ? 1 : 2;
    return is;
}

static int ends_branch(const struct parser *p)
{
    return !*p->at || is_operator(p, '|') || (is_operator(p, ')') && (p->depth || !p->extended));
}

static int look_at(struct parser *p, enum look what)
{
    p->begins = BEHIND_LOOK;
    return add_piece(p, (struct piece){.kind = LOOK, .number = (int)what});
}

static int read_alternatives(struct parser *p);

static int read_group(struct parser *p)
{
    int number = ++p->r->groups;
    p->depth++;
    p->begins = 1;
    int inside = read_alternatives(p);
    p->depth--;
    if (!p->error && !take_operator(p, ')'))
        fail(p, REG_EPAREN);
    p->begins = 0;
    if (number < 10)
        p->closed |= 1u << number;
    return add_piece(p, (struct piece){.kind = GROUP, .a = inside, .number = number});
}

static int back_reference(struct parser *p, int number)
{
    if (!(p->closed >> number & 1))
        return fail(p, REG_ESUBREG);
    p->r->has_back = 1;
    return add_piece(p, (struct piece){.kind = BACK, .number = number});
}

/* Behind a backslash. */
static int read_escaped(struct parser *p)
{
    static const char looks[] = "<>bB`'";
    static const enum look of[] = {WORD_BEGINS, WORD_ENDS, AT_WORD, NOT_AT_WORD, TEXT_BEGINS, TEXT_ENDS};
    int c = (unsigned char)*p->at++;
    if (!c)
        return fail(p, REG_EESCAPE);
    if (strchr(looks, c))
        return look_at(p, of[strchr(looks, c) - looks]);
    if (c >= '1' && c <= '9')
        return back_reference(p, c - '0');
    if (c == 'w' || c == 'W')
        return of_class(p, is_word, c == 'W');
    if (c == 's' || c == 'S')
        return of_class(p, isspace, c == 'S');
    return one_character(p, c);
}

/* In an extended expression. */
static int begins_repetition(const struct parser *p)
{
    return *p->at && strchr("*+?{", *p->at);
}

/* Is the $ behind p->at an anchor? */
static int ends_here(const struct parser *p)
{
    return p->extended || !*p->at || is_escaped(p, ')') || is_escaped(p, '|');
}

static int read_atom(struct parser *p)
{
    int begins = p->begins;
    if (begins && (p->extended ? begins_repetition(p) : is_operator(p, '{')))
        return fail(p, REG_BADRPT);
    p->begins = 0;
    if (take_operator(p, '('))
        return read_group(p);
    switch (*p->at++) {
    case '\\':
        return read_escaped(p);
    case '[':
        return read_brackets(p);
    case '.':
        return any_character(p);
    case '^':
        return p->extended || begins == 1 ? look_at(p, LINE_BEGINS) : one_character(p, '^');
    case '$':
        return ends_here(p) ? look_at(p, LINE_ENDS) : one_character(p, '$');
    default:
        return one_character(p, (unsigned char)p->at[-1]);
    }
}

/* A number of an interval, -1 if there is none. */
static int read_number(struct parser *p)
{
    int n = isdigit((unsigned char)*p->at) ? 0 : -1;
    while (isdigit((unsigned char)*p->at)) {
        n = 10 * n + *p->at++ - '0';
        if (n > MOST_TIMES) {
            fail(p, REG_ESIZE);
            return n;
        }
    }
    return n;
}

/* Behind the brace. */
static void read_interval(struct parser *p, int *min, int *max)
{
    *min = *max = read_number(p);
    if (*p->at == ',') {
        p->at++;
        *max = read_number(p); /* -1: ANY_NUMBER */
        if (*min < 0)
            *min = 0;
    }
    if (!*p->at)
        fail(p, REG_EBRACE);
    else if (*min < 0 || (*max != ANY_NUMBER && *max < *min) || !take_operator(p, '}'))
        fail(p, REG_BADBR);
}

static int read_repetition(struct parser *p, int *min, int *max)
{
    *min = 0, *max = ANY_NUMBER;
    if (*p->at == '*')
        p->at++;
    else if (take_operator(p, '+'))
        *min = 1;
    else if (take_operator(p, '?'))
        *max = 1;
    else if (take_operator(p, '{'))
        read_interval(p, min, max);
    else
        return 0;
    return 1;
}

/* An atom and its repetitions. */
static int read_piece(struct parser *p)
{
    int groups = p->r->groups, piece = read_atom(p), min, max;
    while (!p->error && !p->begins && read_repetition(p, &min, &max)) {
        piece = add_piece(p, (struct piece){.kind = REPEAT,
                                            .a = piece,
                                            .min = min,
                                            .max = max,
                                            .number = groups + 1,
                                            .groups = p->r->groups - groups});
        if (!p->extended && (*p->at == '*' || is_operator(p, '{')))
            fail(p, REG_BADRPT); /* as GNU's: there it follows none */
    }
    return piece;
}

static int read_branch(struct parser *p)
{
    if (p->error || ends_branch(p))
        return add_piece(p, (struct piece){.kind = EMPTY});
    int a = read_piece(p);
    if (p->error || ends_branch(p))
        return a;
    int b = read_branch(p);
    return add_piece(p, (struct piece){.kind = CAT, .a = a, .b = b});
}

static int read_alternatives(struct parser *p)
{
    int a = read_branch(p);
    if (p->error || !take_operator(p, '|'))
        return a;
    p->begins = 1;
    int b = read_alternatives(p);
    return add_piece(p, (struct piece){.kind = ALT, .a = a, .b = b});
}

/* --- steps --- */

static int add_step(struct parser *p, struct step is)
{
    struct regex *r = p->r;
    void *list = r->steps;
    if (p->error || r->step_count > MOST_STEPS || !one_more(&list, r->step_count, sizeof is))
        return fail(p, REG_ESPACE);
    r->steps = list;
    r->steps[r->step_count] = is;
    return r->step_count++;
}

static void make_steps(struct parser *p, int piece);

static void make_alternatives(struct parser *p, const struct piece *x)
{
    int split = add_step(p, (struct step){.kind = STEP_SPLIT});
    make_steps(p, x->a);
    int jump = add_step(p, (struct step){.kind = STEP_JUMP});
    int second = p->r->step_count;
    make_steps(p, x->b);
    if (p->error)
        return;
    p->r->steps[split].a = split + 1;
    p->r->steps[split].b = second;
    p->r->steps[jump].a = p->r->step_count;
}

/* One time that may be left out, for which the steps go on at `out`; again: once more behind it. */
static void make_choice(struct parser *p, int piece, int out, int again)
{
    int split = add_step(p, (struct step){.kind = STEP_SPLIT, .b = out});
    make_steps(p, piece);
    if (again)
        add_step(p, (struct step){.kind = STEP_JUMP, .a = split});
    if (!p->error)
        p->r->steps[split].a = split + 1;
}

/* The times that must be, then those that may be; each has the same number of steps. */
static void make_repetition(struct parser *p, struct piece *x)
{
    int begin = p->r->step_count;
    for (int i = 0; i < x->min && !p->error; i++)
        make_steps(p, x->a);
    if (x->max == ANY_NUMBER) {
        int split = p->r->step_count;
        make_choice(p, x->a, 0, 1);
        x->copy = p->r->step_count - split - 2;
        if (!p->error)
            p->r->steps[split].b = p->r->step_count;
        return;
    }
    if (x->min)
        x->copy = (p->r->step_count - begin) / x->min;
    int first = p->r->step_count;
    for (int i = x->min; i < x->max && !p->error; i++) {
        make_choice(p, x->a, 0, 0);
        x->copy = (p->r->step_count - first) / (i + 1 - x->min) - 1;
    }
    for (int i = x->min; i < x->max && !p->error; i++)
        p->r->steps[first + (i - x->min) * (x->copy + 1)].b = p->r->step_count;
}

static void make_steps(struct parser *p, int piece)
{
    struct piece *x = &p->r->pieces[piece]; /* no piece is added any more */
    if (p->error)
        return;
    x->from = p->r->step_count;
    switch (x->kind) {
    case SET:
        add_step(p, (struct step){.kind = STEP_SET, .number = x->number, .a = x->from + 1});
        break;
    case LOOK:
        add_step(p, (struct step){.kind = STEP_LOOK, .number = x->number, .a = x->from + 1});
        break;
    case CAT:
        make_steps(p, x->a);
        make_steps(p, x->b);
        break;
    case ALT:
        make_alternatives(p, x);
        break;
    case REPEAT:
        make_repetition(p, x);
        break;
    case GROUP:
        make_steps(p, x->a);
        break;
    case EMPTY:
    case BACK:
        break;
    }
    x->to = p->r->step_count;
}

/* Finds with which characters the expression may begin, from a step on. */
static void look_ahead(struct regex *r, int at, char *seen)
{
    for (; at < r->step_count && !seen[at]; at = r->steps[at].a) {
        const struct step *s = &r->steps[at];
        seen[at] = 1;
        if (s->kind == STEP_SET) {
            for (int i = 0; i < 32; i++)
                r->first[i] |= r->sets[s->number][i];
            return;
        }
        if (s->kind == STEP_SPLIT)
            look_ahead(r, s->b, seen);
    }
    if (at >= r->step_count)
        r->may_be_empty = 1;
}

/* --- the calls --- */

static void free_regex(struct regex *r)
{
    if (!r)
        return;
    free(r->pieces);
    free(r->sets);
    free(r->steps);
    free(r);
}

static int compile(struct regex *r, const char *pattern)
{
    struct parser p = {.r = r, .at = pattern, .extended = r->flags & REG_EXTENDED, .begins = 1};
    r->root = read_alternatives(&p);
    if (!p.error && *p.at)
        fail(&p, REG_EPAREN);
    if (p.error)
        return p.error;
    make_steps(&p, r->root);
    char *seen = p.error ? NULL : calloc((size_t)r->step_count + 1, 1);
    if (!seen)
        return p.error ? p.error : REG_ESPACE;
    look_ahead(r, 0, seen);
    free(seen);
    return 0;
}

int regcomp(regex_t *restrict re, const char *restrict pattern, int flags)
{
    struct regex *r = calloc(1, sizeof *r);
    memset(re, 0, sizeof *re);
    if (!r)
        return REG_ESPACE;
    r->flags = flags;
    int error = compile(r, pattern);
    if (error) {
        free_regex(r);
        return error;
    }
    re->buffer = (void *)r;
    re->re_nsub = (size_t)r->groups;
    return 0;
}

void regfree(regex_t *re)
{
    free_regex((void *)re->buffer);
    re->buffer = NULL;
}

size_t regerror(int code, const regex_t *restrict re, char *restrict text, size_t room)
{
    static const char *const texts[] = {"Success",
                                        "No match",
                                        "Invalid regular expression",
                                        "Invalid collation character",
                                        "Invalid character class name",
                                        "Trailing backslash",
                                        "Invalid back reference",
                                        "Unmatched [, [^, [:, [., or [=",
                                        "Unmatched ( or \\(",
                                        "Unmatched \\{",
                                        "Invalid content of \\{\\}",
                                        "Invalid range end",
                                        "Memory exhausted",
                                        "Invalid preceding regular expression",
                                        "Premature end of regular expression",
                                        "Regular expression too big",
                                        "Unmatched ) or \\)"};
    (void)re;
    const char *is = (unsigned)code < sizeof texts / sizeof *texts ? texts[code] : "Unknown error";
    if (room)
        snprintf(text, room, "%s", is);
    return strlen(is) + 1;
}
