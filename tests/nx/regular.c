/* Regular expressions, as POSIX says: the first place, the longest text there, the groups, errors.
 * simulator only: a cluster's library has other groups where POSIX is not clear
 * compile: -D_GNU_SOURCE
 * again: --long32
 * run: all
 */
#include <fnmatch.h>
#include <regex.h>
#include <stdlib.h>
#include <string.h>
#include "rule.h"

/* What an expression finds in a text, as "0-3 1-2 -": of the whole and its groups. */
static const char *found(const char *pattern, const char *text, int flags, int how)
{
    static char answer[200];
    regex_t re;
    regmatch_t g[10];
    int error = regcomp(&re, pattern, flags);
    if (error) {
        regerror(error, &re, answer, sizeof answer);
        return answer;
    }
    strcpy(answer, "no");
    if (regexec(&re, text, 10, g, how) == 0) {
        size_t used = 0;
        for (size_t i = 0; i <= re.re_nsub; i++)
            used += (size_t)snprintf(answer + used, sizeof answer - used, g[i].rm_so < 0 ? " -" : " %d-%d",
                                     (int)g[i].rm_so, (int)g[i].rm_eo);
    }
    regfree(&re);
    return answer + (*answer == ' ');
}

static int basic(const char *pattern, const char *text, const char *expected)
{
    return !strcmp(found(pattern, text, 0, 0), expected);
}

static int extended(const char *pattern, const char *text, const char *expected)
{
    return !strcmp(found(pattern, text, REG_EXTENDED, 0), expected);
}

static int anchors_and_flags(void)
{
    return !strcmp(found("^b$", "a\nb\nc", REG_NEWLINE, 0), "2-3") &&
           !strcmp(found("^b", "a\nb", 0, 0), "no") && !strcmp(found("^a", "ab", 0, REG_NOTBOL), "no") &&
           !strcmp(found("b$", "ab", 0, REG_NOTEOL), "no") &&
           !strcmp(found("a.c", "a\nc", REG_NEWLINE, 0), "no") &&
           !strcmp(found("[^x]x", "\nx", REG_NEWLINE, 0), "no") &&
           !strcmp(found("straSSe", "STRASSE", REG_ICASE, 0), "0-7");
}

static int errors(void)
{
    static const struct {
        const char *pattern, *text;
    } wrong[] = {{"a\\", "Trailing backslash"},
                 {"[a", "Unmatched [, [^, [:, [., or [="},
                 {"(a", "Unmatched ( or \\("},
                 {"a)", ""},
                 {"a{2", "Unmatched \\{"},
                 {"a{2,1}", "Invalid content of \\{\\}"},
                 {"[b-a]", "Invalid range end"},
                 {"[[:none:]]", "Invalid character class name"},
                 {"*a", "Invalid preceding regular expression"},
                 {"\\1(a)", "Invalid back reference"}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        if (*wrong[i].text && !extended(wrong[i].pattern, "a", wrong[i].text))
            return 0;
    return extended("a)", "xa)", "1-3") && basic("a\\)", "a", "Unmatched ( or \\(");
}

/* Nothing is told but whether. */
static int without_places(void)
{
    regex_t re;
    regmatch_t g = {-7, -7};
    int good = regcomp(&re, "(a+)b", REG_EXTENDED | REG_NOSUB) == 0 && regexec(&re, "xaab", 1, &g, 0) == 0;
    good = good && g.rm_so == -7 && regexec(&re, "xaa", 0, NULL, 0) == REG_NOMATCH;
    regfree(&re);
    return good;
}

/* The time grows with the text, not with its ways to be divided. */
static int no_explosion(void)
{
    char text[400];
    memset(text, 'a', sizeof text - 1);
    text[sizeof text - 1] = 0;
    return extended("^(a|aa)*(a*)*b", text, "no") && extended("^(a?){40}a{40}", text, "0-80 39-40");
}

static int part_of_a_text(void)
{
    regex_t re;
    regmatch_t g[2] = {{3, 6}};
    int good = regcomp(&re, "\\(b*\\)$", 0) == 0 && regexec(&re, "bb bbcbb", 2, g, REG_STARTEND) == 0;
    good = good && g[0].rm_so == 6 && g[1].rm_eo == 6;
    regfree(&re);
    g[0].rm_so = 3, g[0].rm_eo = 6;
    return good && regcomp(&re, "^b", 0) == 0 && regexec(&re, "bb bbcbb", 2, g, REG_STARTEND) == REG_NOMATCH;
}

int main(void)
{
    rule("the first, and there the longest", extended("b+|bb?c", "abbcbbb", "1-4") &&
                                                 extended("x*", "aax", "0-0") &&
                                                 extended("xyz|xy", "xyxyz", "0-2"));
    rule("groups from left to right", extended("(a|ab)(c|bcd)(d*)", "abcd", "0-4 0-2 2-3 3-4") &&
                                          extended("(a*)(ab)*(b*)", "abb", "0-3 0-1 - 1-3") &&
                                          extended("((a)|b)+", "ab", "0-2 1-2 -"));
    rule("basic ones", basic("\\(a*\\)b\\{2\\}", "aabb", "0-4 0-2") && basic("*a+", "b*a+", "1-4") &&
                           basic("a\\|b\\+", "bb", "0-2") && basic("a^b$c", "a^b$c", "0-5"));
    rule("sets", extended("[]a-c]+", "x]cb", "1-4") && extended("[^[:digit:]_-]+", "1a b-", "1-4") &&
                     extended("[[.-.][=a=]]+", "b-a", "1-3"));
    rule("words", extended("\\<in\\>", "within in", "7-9") && extended("\\w+\\b", " ab_1-", "1-5") &&
                      extended("\\Bb\\W", "ab b-ab-", "1-3"));
    rule("intervals", extended("a{2,3}", "aaaa", "0-3") && extended("(ab){2}", "ababab", "0-4 2-4") &&
                          extended("a{,1}b{0}c", "ac", "0-2"));
    rule("back references",
         basic("\\(.*\\)-\\1$", "xab-ab", "1-6 1-3") && extended("(a*)(b|c)\\1\\2", "aabab", "1-5 1-2 2-3"));
    rule("anchors and flags", anchors_and_flags());
    rule("REG_NOSUB", without_places());
    rule("errors", errors());
    rule("long texts", no_explosion());
    rule("a part of a text", part_of_a_text());
    rule("fnmatch", fnmatch("*.[ch]", "a.c", 0) == 0 && fnmatch("*", "a/b", FNM_PATHNAME) == FNM_NOMATCH);
    return 0;
}
