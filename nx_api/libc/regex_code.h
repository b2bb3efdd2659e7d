/* regex_code.h - a regular expression as regcomp makes it and regexec uses it: a tree of pieces, and steps.
 *
 *     a(b|c)*      CAT( SET a, REPEAT( GROUP 1( ALT( SET b, SET c )), 0, any ))
 *
 *     0 SET a   1 SPLIT 2 6   2 SPLIT 3 5   3 SET b   4 JUMP 6   5 SET c   6 JUMP 1   7 (the end)
 *
 * Each piece has its own steps, without gaps, from `from` to before `to`: who comes to `to` is through. So
 * whether a piece fits a part of a text can be asked of any piece, and of what follows in a chain. */
#ifndef LIBC_REGEX_CODE_H
#define LIBC_REGEX_CODE_H

enum piece_kind { EMPTY, SET, LOOK, CAT, ALT, REPEAT, GROUP, BACK };

/* What a LOOK asks of a place in the text. */
enum look { LINE_BEGINS, LINE_ENDS, WORD_BEGINS, WORD_ENDS, AT_WORD, NOT_AT_WORD, TEXT_BEGINS, TEXT_ENDS };

enum { ANY_NUMBER = -1 };

struct piece {
    enum piece_kind kind;
    int a, b;     /* the pieces it consists of; b is right of a */
    int number;   /* of a set, a look, a group; REPEAT: of the first group in it */
    int groups;   /* REPEAT: how many are in it */
    int min, max; /* REPEAT: how often */
    int copy;     /* REPEAT: steps for one time */
    int from, to;
};

enum step_kind { STEP_SET, STEP_LOOK, STEP_SPLIT, STEP_JUMP };

struct step {
    enum step_kind kind;
    int number; /* of the set or look */
    int a, b;   /* where to go: b for STEP_SPLIT only */
};

struct regex {
    int flags;
    struct piece *pieces;
    unsigned char (*sets)[32]; /* a bit for each character */
    struct step *steps;
    int piece_count, set_count, step_count;
    int root, groups;
    int has_back;            /* there are back references: steps do not tell */
    unsigned char first[32]; /* with what it may begin */
    int may_be_empty;        /* or it may fit no character */
};

static inline int set_has(const unsigned char *set, int c)
{
    return set[c >> 3] >> (c & 7) & 1;
}
#endif
