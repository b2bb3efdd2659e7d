/* regexec.c - the search for a regular expression in a text: the first place, there the longest text, and of
 * each piece from left to right the longest that this leaves, as POSIX says.
 *
 * Where it begins and ends is found by following all ways through the steps at once, a character at a time
 * (Thompson 1968). Then the text is divided among the pieces from the root down: each is asked how far it may
 * reach so that what follows fits the rest. With back references all ways are tried, one after the other. */
#define _GNU_SOURCE
#include <ctype.h>
#include <regex.h>
#include <stdlib.h>
#include <string.h>
#include "regex_code.h"

struct match {
    const struct regex *r;
    const char *text;
    int length, flags;
    int any;         /* the first end will do */
    int *seen;       /* of each step: the round in which it was reached */
    int *now, *next; /* steps that wait for a character */
    int *ways;       /* steps to go to */
    int round;
    regmatch_t *group; /* 0 is the whole */
};

/* --- places --- */

static int is_word_at(const struct match *m, int at)
{
    if (at < 0 || at >= m->length)
        return 0;
    unsigned char c = (unsigned char)m->text[at];
    return isalnum(c) || c == '_';
}

static int holds(const struct match *m, enum look what, int at)
{
    int before = is_word_at(m, at - 1), behind = is_word_at(m, at), lines = m->r->flags & REG_NEWLINE;
    switch (what) {
    case LINE_BEGINS:
        return at == 0 ? !(m->flags & REG_NOTBOL) : lines && m->text[at - 1] == '\n';
    case LINE_ENDS:
        return at == m->length ? !(m->flags & REG_NOTEOL) : lines && m->text[at] == '\n';
    case WORD_BEGINS:
        return !before && behind;
    case WORD_ENDS:
        return before && !behind;
    case AT_WORD:
        return before != behind;
    case NOT_AT_WORD:
        return before == behind;
    case TEXT_BEGINS:
        return at == 0;
    default:
        return at == m->length;
    }
}

/* --- all ways at once --- */

/* Goes from a step, without a character, to all that it leads to, and adds those that wait for one to a list.
 * Is `to` among them? */
static int go(struct match *m, int from, int to, int at, int *list, int *count)
{
    int ways = 0, through = 0;
    m->ways[ways++] = from;
    while (ways) {
        int s = m->ways[--ways];
        if (s == to)
            through = 1;
        if (s == to || m->seen[s] == m->round)
            continue;
        m->seen[s] = m->round;
        const struct step *step = &m->r->steps[s];
        if (step->kind == STEP_SET)
            list[(*count)++] = s;
        else if (step->kind != STEP_LOOK || holds(m, (enum look)step->number, at))
            m->ways[ways++] = step->a;
        if (step->kind == STEP_SPLIT)
            m->ways[ways++] = step->b;
    }
    return through;
}

/* The furthest place, at most `most`, to which the steps from `from` to before `to` fit what begins at a
 * place; -1: they do not. */
static int furthest(struct match *m, int from, int to, int at, int most)
{
    int count = 0, best = -1;
    m->round++;
    if (at <= most && go(m, from, to, at, m->now, &count))
        best = at;
    for (; count && at < most && !(m->any && best >= 0); at++) {
        int c = (unsigned char)m->text[at], more = 0;
        m->round++;
        for (int i = 0; i < count; i++) {
            const struct step *s = &m->r->steps[m->now[i]];
            if (set_has(m->r->sets[s->number], c) && go(m, s->a, to, at + 1, m->next, &more))
                best = at + 1;
        }
        int *was = m->now;
        m->now = m->next;
        m->next = was;
        count = more;
    }
    return best;
}

static int fits(struct match *m, int from, int to, int at, int end)
{
    return furthest(m, from, to, at, end) == end;
}

/* --- the groups --- */

/* How far a piece reaches from a place, so that the steps from `rest` to before `to` fit what is left before
 * `end`. There is such a place. */
static int reach(struct match *m, const struct piece *x, int at, int end, int rest, int to)
{
    int k = furthest(m, x->from, x->to, at, end);
    while (k > at && !fits(m, rest, to, k, end))
        k = furthest(m, x->from, x->to, at, k - 1);
    return k;
}

static void divide(struct match *m, int piece, int at, int end);

/* The step behind so many times. */
static int behind_times(const struct piece *x, int times)
{
    if (times <= x->min)
        return x->from + times * x->copy;
    int begin = x->from + x->min * x->copy;
    return x->max == ANY_NUMBER ? begin : begin + (times - x->min) * (x->copy + 1);
}

static void divide_times(struct match *m, const struct piece *x, int at, int end)
{
    const struct piece *once = &m->r->pieces[x->a];
    for (int times = 0; times != x->max && (times < x->min || at < end || times == 0); times++) {
        if (times >= x->min && at == end && !fits(m, once->from, once->to, at, at))
            return;
        int k = reach(m, once, at, end, behind_times(x, times + 1), x->to);
        for (int g = x->number; g < x->number + x->groups; g++)
            m->group[g].rm_so = m->group[g].rm_eo = -1;
        divide(m, x->a, at, k);
        at = k;
    }
}

static void divide(struct match *m, int piece, int at, int end)
{
    const struct piece *x = &m->r->pieces[piece], *a = &m->r->pieces[x->a], *b = &m->r->pieces[x->b];
    switch (x->kind) {
    case GROUP:
        m->group[x->number].rm_so = at;
        m->group[x->number].rm_eo = end;
        divide(m, x->a, at, end);
        break;
    case CAT: {
        int k = reach(m, a, at, end, b->from, b->to);
        divide(m, x->a, at, k);
        divide(m, x->b, k, end);
        break;
    }
    case ALT:
        divide(m, fits(m, a->from, a->to, at, end) ? x->a : x->b, at, end);
        break;
    case REPEAT:
        divide_times(m, x, at, end);
        break;
    default:
        break;
    }
}

/* --- one way after the other, for back references --- */

/* What follows a piece: another one, the end of a group, or the next time of a repetition. */
struct follow {
    int piece, at; /* REPEAT and GROUP: where it began */
    int times;     /* REPEAT: done before */
    const struct follow *then;
};

struct trial {
    struct match *m;
    int best;
    regmatch_t *group, *best_group;
};

static void try(struct trial *t, int piece, int at, const struct follow *then);

static void try_times(struct trial *t, int piece, int times, int at, const struct follow *then);

static void go_on(struct trial *t, int at, const struct follow *f)
{
    size_t groups = (size_t)t->m->r->groups + 1;
    if (!f) {
        if (at > t->best)
            memcpy(t->best_group, t->group, groups * sizeof *t->group), t->best = at;
        return;
    }
    const struct piece *x = &t->m->r->pieces[f->piece];
    if (f->times >= 0) {
        if (at > f->at || f->times <= x->min)
            try_times(t, f->piece, f->times, at, f->then);
    } else if (x->kind == GROUP && f->at >= 0) {
        regmatch_t before = t->group[x->number];
        t->group[x->number] = (regmatch_t){f->at, at};
        go_on(t, at, f->then);
        t->group[x->number] = before;
    } else {
        try(t, f->piece, at, f->then);
    }
}

static void try_times(struct trial *t, int piece, int times, int at, const struct follow *then)
{
    const struct piece *x = &t->m->r->pieces[piece];
    if (x->max == ANY_NUMBER || times < x->max)
        try(t, x->a, at, &(struct follow){piece, at, times + 1, then});
    if (times >= x->min)
        go_on(t, at, then);
}

static void try_back(struct trial *t, const struct piece *x, int at, const struct follow *then)
{
    const regmatch_t *g = &t->group[x->number];
    int bytes = g->rm_eo - g->rm_so;
    const char *text = t->m->text;
    if (g->rm_so < 0 || bytes > t->m->length - at)
        return;
    int same = t->m->r->flags & REG_ICASE ? !strncasecmp(text + g->rm_so, text + at, (size_t)bytes)
                                          : !memcmp(text + g->rm_so, text + at, (size_t)bytes);
    if (same)
        go_on(t, at + bytes, then);
}

/* Tries all ways, but those that cannot be longer than the best. */
static void try(struct trial *t, int piece, int at, const struct follow *then)
{
    const struct match *m = t->m;
    const struct piece *x = &m->r->pieces[piece];
    if (t->best == m->length)
        return;
    switch (x->kind) {
    case EMPTY:
        go_on(t, at, then);
        break;
    case SET:
        if (at < m->length && set_has(m->r->sets[x->number], (unsigned char)m->text[at]))
            go_on(t, at + 1, then);
        break;
    case LOOK:
        if (holds(m, (enum look)x->number, at))
            go_on(t, at, then);
        break;
    case CAT:
        try(t, x->a, at, &(struct follow){x->b, -1, -1, then});
        break;
    case ALT:
        try(t, x->a, at, then);
        try(t, x->b, at, then);
        break;
    case REPEAT:
        try_times(t, piece, 0, at, then);
        break;
    case GROUP:
        try(t, x->a, at, &(struct follow){piece, at, -1, then});
        break;
    case BACK:
        try_back(t, x, at, then);
        break;
    }
}

/* The end of the longest at a place, -1: none. */
static int try_all(struct match *m, int at, regmatch_t *room)
{
    int groups = m->r->groups + 1;
    struct trial t = {m, -1, room, m->group};
    for (int g = 0; g < groups; g++)
        room[g].rm_so = room[g].rm_eo = -1;
    try(&t, m->r->root, at, NULL);
    return t.best;
}

/* --- the call --- */

/* Sets the groups; nothing else than the whole's is needed if m->any. */
static int search(struct match *m, int from, regmatch_t *room)
{
    const struct regex *r = m->r;
    for (int at = from; at <= m->length; at++) {
        int end;
        if (!r->has_back && !r->may_be_empty &&
            (at == m->length || !set_has(r->first, (unsigned char)m->text[at])))
            continue;
        if (r->has_back)
            end = try_all(m, at, room);
        else
            end = furthest(m, 0, r->step_count, at, m->length);
        if (end < 0)
            continue;
        if (!r->has_back && !m->any && r->groups)
            divide(m, r->root, at, end);
        m->group[0] = (regmatch_t){at, end};
        return 0;
    }
    return REG_NOMATCH;
}

/* (With REG_STARTEND what is before the part is looked at, too, as GNU does: ^ does not fit there.) */
int regexec(const regex_t *restrict re, const char *restrict text, size_t count,
            regmatch_t groups[restrict count], int flags)
{
    const struct regex *r = (const void *)re->buffer;
    size_t own = (size_t)r->groups + 1, steps = (size_t)r->step_count + 1;
    int from = flags & REG_STARTEND ? groups[0].rm_so : 0;
    struct match m = {.r = r, .text = text, .flags = flags};
    m.length = flags & REG_STARTEND ? groups[0].rm_eo : (int)strlen(text);
    if (r->flags & REG_NOSUB)
        count = 0;
    m.any = count == 0;
    m.group = malloc(2 * own * sizeof *m.group);
    m.seen = calloc(5 * steps, sizeof *m.seen);
    if (!m.group || !m.seen) {
        free(m.group);
        free(m.seen);
        return REG_ESPACE;
    }
    m.now = m.seen + steps, m.next = m.now + steps, m.ways = m.next + steps;
    for (size_t g = 0; g < own; g++)
        m.group[g].rm_so = m.group[g].rm_eo = -1;
    int answer = search(&m, from, m.group + own);
    for (size_t g = 0; !answer && g < count; g++)
        groups[g] = g < own ? m.group[g] : (regmatch_t){-1, -1};
    free(m.group);
    free(m.seen);
    return answer;
}
