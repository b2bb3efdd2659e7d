/* re_comp.c - regular expressions by BSD's calls, which keep one: POSIX's basic ones. */
#define _GNU_SOURCE
#define _REGEX_RE_COMP
#include <regex.h>
#include <stddef.h>

static regex_t kept;
static int is_kept;

/* The text of an error; NULL: none. An empty expression is the one before. */
char *re_comp(const char *pattern)
{
    static char text[80];
    if (!pattern || !*pattern)
        return is_kept ? NULL : "No previous regular expression";
    if (is_kept)
        regfree(&kept);
    int error = regcomp(&kept, pattern, REG_NEWLINE);
    is_kept = !error;
    if (!error)
        return NULL;
    regerror(error, &kept, text, sizeof text);
    return text;
}

int re_exec(const char *text)
{
    return is_kept && regexec(&kept, text, 0, NULL, 0) == 0;
}
