/* command_line.c - see command_line.h. */
#include "nx_api/driver/command_line.h"
#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/driver/text.h"

enum { DEEPEST = 20 }; /* files that name files */

struct list {
    char **text;
    int count;
};

static void append(struct list *l, char *argument)
{
    l->text = reallocarray(l->text, (size_t)l->count + 1, sizeof *l->text);
    if (!l->text)
        fail("out of memory");
    l->text[l->count++] = argument;
}

/* Cuts the next word off, as GCC has them: blanks separate words, except in quotes, and \ stands before any
 * character. NULL: there are no more. */
static char *next_word(char **rest)
{
    char *from = *rest + strspn(*rest, " \t\n\v\f\r"), *word = from, *to = from, quote = 0;
    if (!*from)
        return NULL;
    for (; *from && (quote || !isspace((unsigned char)*from)); from++) {
        if (*from == '\\' && from[1])
            *to++ = *++from;
        else if (*from == quote)
            quote = 0;
        else if (!quote && (*from == '\'' || *from == '"'))
            quote = *from;
        else
            *to++ = *from;
    }
    *rest = *from ? from + 1 : from;
    *to = '\0';
    return word;
}

/* As GCC does, takes @FILE as it is if there is no such file. */
static void add(struct list *l, char *argument, int depth)
{
    char *words = NULL, *word;
    size_t size = 0;
    FILE *f = *argument == '@' ? fopen(argument + 1, "re") : NULL;
    if (!f) {
        append(l, argument);
        return;
    }
    if (depth == DEEPEST)
        fail("%s: too many such files, one in another", argument);
    if (getdelim(&words, &size, '\0', f) > 0)
        for (char *rest = words; (word = next_word(&rest));)
            add(l, word, depth + 1);
    fclose(f);
}

/* Options whose values are often in one with them. */
static void join_values(struct list *l)
{
    int count = 0;
    for (int i = 0; i < l->count; i++) {
        char *s = l->text[i];
        bool apart = !strcmp(s, "-l") || !strcmp(s, "-L") || !strcmp(s, "-x");
        l->text[count++] = apart && i + 1 < l->count ? text("%s%s", s, l->text[++i]) : s;
    }
    l->count = count;
}

char **command_line_read(int *argc, char **argv)
{
    struct list l = {NULL, 0};
    append(&l, argv[0]);
    for (int i = 1; i < *argc; i++)
        add(&l, argv[i], 0);
    join_values(&l);
    *argc = l.count;
    append(&l, NULL);
    return l.text;
}
