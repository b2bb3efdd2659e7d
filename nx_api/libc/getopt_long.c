/* getopt_long.c - options of several letters, as GNU has them; other arguments come to stand behind. */
#include <getopt.h>
#include <stdio.h>
#include <string.h>

static const char *inside; /* of several letters in one argument, those still to come */
static int passed;         /* arguments from optind on that are no options */

static int is_option(const char *argument)
{
    return argument[0] == '-' && argument[1];
}

/* Takes the argument behind those that were passed. */
static char *take(char **argv)
{
    char *taken = argv[optind + passed];
    memmove(argv + optind + 1, argv + optind, (size_t)passed * sizeof *argv);
    argv[optind++] = taken;
    return taken;
}

static const char *behind_sign(const char *letters)
{
    return letters + (*letters == '+' || *letters == '-');
}

/* Says what is wrong with an option, unless the program wants to. */
static int wrong(char **argv, const char *letters, const char *format, int length, const char *name)
{
    if (opterr && *behind_sign(letters) != ':') {
        fprintf(stderr, "%s: ", argv[0]);
        fprintf(stderr, format, length, name);
        fputc('\n', stderr);
    }
    return '?';
}

static int wants_value(char **argv, const char *letters, const char *format, int length, const char *name)
{
    wrong(argv, letters, format, length, name);
    return *behind_sign(letters) == ':' ? ':' : '?';
}

static int take_letter(int argc, char **argv, const char *letters)
{
    const char *letter = inside++, *rest = *inside ? inside : NULL;
    const char *known = strchr(behind_sign(letters), *letter);
    optopt = (unsigned char)*letter;
    if (!rest)
        inside = NULL;
    if (!known || *letter == ':')
        return wrong(argv, letters, "invalid option -- '%.*s'", 1, letter);
    if (known[1] != ':')
        return optopt;
    inside = NULL;
    optarg = (char *)(size_t)rest;
    if (rest || known[2] == ':')
        return optopt;
    if (optind + passed >= argc)
        return wants_value(argv, letters, "option requires an argument -- '%.*s'", 1, letter);
    optarg = take(argv);
    return optopt;
}

/* The option of that name, or the only one that begins so; *count: how many do. */
static const struct option *find(const struct option *longs, const char *name, size_t length, int *count)
{
    const struct option *found = NULL;
    *count = 0;
    for (const struct option *o = longs; o->name; o++) {
        if (strncmp(o->name, name, length) != 0)
            continue;
        found = o;
        ++*count;
        if (!o->name[length]) {
            *count = 1;
            break;
        }
    }
    return found;
}

/* dashed: the argument. */
static int take_long(int argc, char **argv, const char *letters, const struct option *o, const char *dashed)
{
    int length = (int)strcspn(dashed, "=");
    optopt = o->val;
    if (dashed[length]) {
        if (o->has_arg == no_argument)
            return wrong(argv, letters, "option '%.*s' doesn't allow an argument", length, dashed);
        optarg = (char *)(size_t)(dashed + length + 1);
    } else if (o->has_arg == required_argument) {
        if (optind + passed >= argc)
            return wants_value(argv, letters, "option '%.*s' requires an argument", length, dashed);
        optarg = take(argv);
    }
    if (!o->flag)
        return o->val;
    *o->flag = o->val;
    return 0;
}

/* only: one dash, too, begins a name of several letters. */
static int next_option(int argc, char **argv, const char *letters, const struct option *longs, int *index,
                       int only)
{
    optarg = NULL;
    if (optind == 0)
        optind = 1, passed = 0, inside = NULL;
    if (inside)
        return take_letter(argc, argv, letters);
    if (*letters != '+' && *letters != '-')
        while (optind + passed < argc && !is_option(argv[optind + passed]))
            passed++;
    const char *next = optind + passed < argc ? argv[optind + passed] : NULL;
    if (!next || (*letters == '+' && !is_option(next))) {
        passed = 0;
        return -1;
    }
    take(argv);
    if (!is_option(next)) {
        optarg = (char *)(size_t)next;
        return 1;
    }
    if (strcmp(next, "--") == 0) {
        passed = 0;
        return -1;
    }
    int dashes = next[1] == '-' ? 2 : 1, count = 0;
    int is_letter = dashes == 1 && strchr(behind_sign(letters), next[1]);
    if (dashes == 2 || (only && (next[2] || !is_letter))) {
        const struct option *o = find(longs, next + dashes, strcspn(next + dashes, "="), &count);
        if (count == 1) {
            if (index)
                *index = (int)(o - longs);
            return take_long(argc, argv, letters, o, next);
        }
    }
    if (dashes == 2 || count > 1 || (only && !is_letter)) {
        optopt = 0;
        return wrong(argv, letters, count ? "option '%.*s' is ambiguous" : "unrecognized option '%.*s'",
                     (int)strlen(next), next);
    }
    inside = next + 1;
    return take_letter(argc, argv, letters);
}

int getopt_long(int argc, char *const *argv, const char *letters, const struct option *longs, int *index)
{
    return next_option(argc, (char **)(size_t)argv, letters, longs, index, 0);
}

int getopt_long_only(int argc, char *const *argv, const char *letters, const struct option *longs, int *index)
{
    return next_option(argc, (char **)(size_t)argv, letters, longs, index, 1);
}
