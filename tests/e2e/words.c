/* words.c - counts the words of a text by hsearch, and lists the most frequent by a tree; node 0 gets the
 * counts of all, each of which takes the lines that are its own. */
#include <ctype.h>
#include <err.h>
#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <nx.h>

enum { MOST = 2000 };

struct word {
    char text[20];
    long count;
};

static struct word words[MOST];
static int known;

static struct word *find(const char *text)
{
    ENTRY *e = hsearch((ENTRY){(char *)text, NULL}, FIND);
    if (e)
        return e->data;
    struct word *w = &words[known++];
    snprintf(w->text, sizeof w->text, "%s", text);
    if (known == MOST || !hsearch((ENTRY){w->text, w}, ENTER))
        errx(1, "too many words");
    return w;
}

static void count_line(char *line)
{
    char *rest = line, *text;
    while ((text = strsep(&rest, " \t\n.,;:()`'\"*/|-"))) {
        for (char *c = text; *c; c++)
            *c = (char)tolower(*c);
        if (*text && strlen(text) < sizeof words->text)
            find(text)->count++;
    }
}

static int by_count(const void *a, const void *b)
{
    const struct word *x = a, *y = b;
    return x->count != y->count ? (x->count < y->count) - (x->count > y->count) : strcmp(x->text, y->text);
}

static int printed;

static void print(const void *node, VISIT when, int level)
{
    const struct word *w = *(struct word *const *)node;
    (void)level;
    if ((when == postorder || when == leaf) && printed++ < 8)
        printf("%5ld %s\n", w->count, w->text);
}

static void print_all(void)
{
    void *root = NULL;
    for (int i = 0; i < known; i++)
        tsearch(&words[i], &root, by_count);
    twalk(root, print);
}

int main(int argc, char **argv)
{
    char *line = NULL;
    size_t room = 0;
    FILE *f = fopen(argv[argc - 1], "r");
    if (!f || !hcreate(MOST))
        err(2, "%s", argv[argc - 1]);
    for (long n = 0; getline(&line, &room, f) > 0; n++)
        if (n % numnodes() == mynode())
            count_line(line);
    fclose(f);
    if (mynode() > 0) {
        csend(1, words, known * sizeof *words, 0, 0);
        return 0;
    }
    static struct word others[MOST];
    for (long i = 1; i < numnodes(); i++) {
        crecv(1, others, sizeof others);
        for (size_t k = 0; k < infocount() / sizeof *others; k++)
            find(others[k].text)->count += others[k].count;
    }
    print_all();
    return 0;
}
