/* getopt.c - options of a program, as POSIX has them: they end at the first argument that is none. As GNU's,
 * an option with two colons takes the rest of its argument, if there is one. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

int optind = 1, opterr = 1, optopt;
char *optarg;

static const char *inside; /* of several in one argument, those still to come */

static int wrong(char *const argv[], const char *options, const char *why, int answer)
{
    if (opterr && *options != ':')
        fprintf(stderr, "%s: %s -- '%c'\n", argv[0], why, optopt);
    return answer;
}

/* The value that an option has: the rest of its argument, or the next one unless it may do without. */
static int take_value(int argc, char *const argv[], const char *options, int may_lack)
{
    const char *rest = inside;
    inside = NULL;
    if (*rest) {
        optarg = (char *)(size_t)rest;
    } else if (may_lack) {
        return optopt;
    } else if (optind < argc) {
        optarg = argv[optind];
        optind++;
    } else {
        return wrong(argv, options, "option requires an argument", *options == ':' ? ':' : '?');
    }
    return optopt;
}

int getopt(int argc, char *const argv[], const char *options)
{
    optarg = NULL;
    if (optind == 0) /* GNU's way to begin again */
        optind = 1, inside = NULL;
    if (!inside || !*inside) {
        const char *next = optind < argc ? argv[optind] : NULL;
        if (!next || next[0] != '-' || !next[1])
            return -1;
        optind++;
        if (strcmp(next, "--") == 0)
            return -1;
        inside = next + 1;
    }
    optopt = (unsigned char)*inside++;
    const char *option = optopt == ':' ? NULL : strchr(options, optopt);
    if (!option)
        return wrong(argv, options, "invalid option", '?');
    return option[1] == ':' ? take_value(argc, argv, options, option[2] == ':') : optopt;
}

/* What a header calls it that is asked for POSIX's only. */
int __posix_getopt(int argc, char *const argv[], const char *options);
int __posix_getopt(int argc, char *const argv[], const char *options)
{
    return getopt(argc, argv, options);
}
