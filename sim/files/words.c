/* words.c - see words.h. */
#include "files/words.h"
#include "kernel/xalloc.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

void words_add(char ***list, char *word)
{
    size_t n = 0;
    while (*list && (*list)[n])
        n++;
    char **more = xrealloc(*list, (n + 2) * sizeof *more);
    more[n] = word;
    more[n + 1] = NULL;
    *list = more;
}

void words_free(char **list)
{
    for (char **word = list; word && *word; word++)
        free(*word);
    free(list);
}

void words_add_all(char ***list, char *text)
{
    char *save;
    for (char *word = strtok_r(text, " ", &save); word; word = strtok_r(NULL, " ", &save))
        words_add(list, xstrdup(word));
    free(text);
}

void words_add_option(char ***list, const char *option, char *value)
{
    words_add(list, xstrdup(option));
    words_add(list, value);
}

void words_add_each(char ***list, const char *option, const char *const *words)
{
    for (; words && *words; words++) {
        if (option)
            words_add(list, xstrdup(option));
        words_add(list, xstrdup(*words));
    }
}

void words_append(char **text, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    char *more = xvasprintf(format, list), *all = xasprintf("%s%s", *text, more);
    va_end(list);
    free(more);
    free(*text);
    *text = all;
}

char *words_filled(const char *text, const char *hole, const char *with)
{
    char *done = xstrdup("");
    for (const char *at; (at = strstr(text, hole)); text = at + strlen(hole))
        words_append(&done, "%.*s%s", (int)(at - text), text, with);
    words_append(&done, "%s", text);
    return done;
}

char *words_quoted(const char *word)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
    if (*word && !word[strspn(word, plain)])
        return xstrdup(word);
    char *inner = words_filled(word, "'", "'\\''"), *quoted = xasprintf("'%s'", inner);
    free(inner);
    return quoted;
}
