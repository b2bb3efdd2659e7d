/* words.c - see words.h. */
#include "lab/jobs/words.h"
#include "kernel/xalloc.h"

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

char *words_filled(const char *text, const char *hole, const char *with)
{
    char *done = xstrdup("");
    for (const char *at; (at = strstr(text, hole)); text = at + strlen(hole)) {
        char *longer = xasprintf("%s%.*s%s", done, (int)(at - text), text, with);
        free(done);
        done = longer;
    }
    char *all = xasprintf("%s%s", done, text);
    free(done);
    return all;
}
