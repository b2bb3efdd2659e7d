/* The C library answers as the standard says: the calendar, divisions, the locale, characters of several
 * bytes, wide output, random numbers, errors, memory at multiples.
 * compile: -D_GNU_SOURCE
 * again: --long32
 * run: all
 */
#include <arpa/inet.h>
#include <errno.h>
#include <getopt.h>
#include <libgen.h>
#include <limits.h>
#include <locale.h>
#include <malloc.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include <wchar.h>
#include "rule.h"

extern int __xpg_strerror_r(int, char *, size_t); /* POSIX's strerror_r */

static int calendar(void)
{
    char text[100];
    struct tm tm = {.tm_year = 93, .tm_mon = 1, .tm_mday = 29, .tm_hour = 25}; /* February 29th, 25 o'clock */
    time_t t = mktime(&tm), again;
    if (tm.tm_mon != 2 || tm.tm_mday != 2 || tm.tm_hour != 1 || tm.tm_wday != 2 || tm.tm_yday != 60)
        return 0;
    again = mktime(localtime(&t));
    strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S %a %B %j %% %y", &tm);
    return again == t && difftime(t + 60, t) == 60 &&
           !strcmp(text, "1993-03-02 01:00:00 Tue March 061 % 93") &&
           !strcmp(asctime(&tm), "Tue Mar  2 01:00:00 1993\n") && strlen(ctime(&t)) == 25 &&
           !strcmp(ctime_r(&t, text), ctime(&t));
}

static int epoch(void)
{
    time_t t = 86400 * 365;
    const struct tm *tm = gmtime(&t);
    return tm->tm_year == 71 && tm->tm_yday == 0 && tm->tm_hour == 0;
}

static int now(void)
{
    time_t t = time(NULL);
    char text[20], *year = ctime(&t) + 20;
    strftime(text, sizeof text, "%Y", localtime(&t));
    return strncmp(year, text, 4) == 0 && atoi(text) > 1992;
}

static int divisions(void)
{
    div_t a = div(-7, 2);
    ldiv_t b = ldiv(7, -2);
    lldiv_t c = lldiv(-10000000000, 3);
    return a.quot == -3 && a.rem == -1 && b.quot == -3 && b.rem == 1 && c.quot == -3333333333 && c.rem == -1;
}

static int one_locale(void)
{
    const struct lconv *c = localeconv();
    return !strcmp(setlocale(LC_ALL, "C"), "C") && !strcmp(setlocale(LC_ALL, NULL), "C") &&
           !setlocale(LC_ALL, "xx_YY") && !strcmp(c->decimal_point, ".") && !*c->thousands_sep &&
           c->frac_digits == CHAR_MAX && strcoll("a", "b") < 0 && strxfrm(NULL, "abc", 0) == 3;
}

static int multibyte(void)
{
    wchar_t w[8];
    char s[8];
    return mblen("a", 1) == 1 && mblen("", 1) == 0 && mblen(NULL, 0) == 0 && mbtowc(w, "xy", 2) == 1 &&
           *w == L'x' && wctomb(s, L'z') == 1 && *s == 'z' && mbstowcs(w, "four", 8) == 4 && wcslen(w) == 4 &&
           wcstombs(s, w, 8) == 4 && !strcmp(s, "four") && mbrlen("a", 1, NULL) == 1;
}

static int wide_files(void)
{
    char name[L_tmpnam];
    wchar_t line[20];
    int x = 0;
    FILE *f = fopen(tmpnam(name), "w+");
    if (!f)
        return 0;
    fwprintf(f, L"line %d %ls\n", 7, L"wide");
    fputws(L"more\n", f);
    fputwc(L'9', f);
    rewind(f);
    fgetws(line, 20, f);
    if (wcscmp(line, L"line 7 wide\n") != 0 || fgetwc(f) != L'm' || ungetwc(L'M', f) != L'M')
        return 0;
    fgetws(line, 20, f);
    x = fwscanf(f, L"%d", &x) == 1 ? x : 0;
    fclose(f);
    remove(name);
    return x == 9 && wcscmp(line, L"More\n") == 0;
}

static int places(void)
{
    char buffer[BUFSIZ], name[L_tmpnam], word[10];
    fpos_t at;
    FILE *f = fopen(tmpnam(name), "w+");
    int good = 1;
    setbuf(f, buffer);
    fputs("one ", f);
    fgetpos(f, &at);
    fputs("two", f);
    good = good && fsetpos(f, &at) == 0 && fscanf(f, "%9s", word) == 1 && !strcmp(word, "two");
    fclose(f);
    remove(name);
    return good;
}

static int read_by_list(const char *from, const char *format, ...)
{
    va_list ap;
    va_start(ap, format);
    int count = vsscanf(from, format, ap);
    va_end(ap);
    return count;
}

static int scanning(void)
{
    long x = 0;
    double y = 0;
    return read_by_list("12 2.5", "%ld %lf", &x, &y) == 2 && x == 12 && y == 2.5;
}

static int options(void)
{
    char *arguments[] = {"program", "-ab", "-n", "3", "-x2", "--", "-c", NULL};
    char seen[40] = "";
    int c;
    optind = 1;
    while ((c = getopt(7, arguments, "abn:x:c")) != -1)
        snprintf(seen + strlen(seen), 8, "%c%s ", c, optarg ? optarg : "");
    int good = !strcmp(seen, "a b n3 x2 ") && optind == 6;
    char *lacks[] = {"p", "-v", "-v3", "-a", NULL};
    optind = 0, *seen = 0;
    while ((c = getopt(4, lacks, "av::")) != -1)
        snprintf(seen + strlen(seen), 8, "%c%s ", c, optarg ? optarg : "");
    return good && !strcmp(seen, "v v3 a ");
}

/* What getopt_long or getopt_long_only finds, and the arguments that are left; these come last. */
static int long_options(__typeof__(getopt_long) *next, const char *letters, char *const *arguments,
                        const char *expected)
{
    static int flag;
    static const struct option longs[] = {{"size", required_argument, NULL, 's'},
                                          {"level", optional_argument, NULL, 'l'},
                                          {"help", no_argument, NULL, 'h'},
                                          {"single", no_argument, &flag, 7},
                                          {NULL, 0, NULL, 0}};
    char *own[12], seen[100] = "";
    int c, count = 0, index = 0;
    while ((own[count] = arguments[count]))
        count++;
    optind = flag = opterr = 0;
    while ((c = next(count, own, letters, longs, &index)) != -1)
        snprintf(seen + strlen(seen), 30, c > 1 ? "%c%s " : "%d%s ", c ? c : flag, optarg ? optarg : "");
    while (optind < count)
        snprintf(seen + strlen(seen), 30, "<%s>", own[optind++]);
    return !strcmp(seen, expected);
}

#define ARGUMENTS (char *const[])
static int options_of_several_letters(void)
{
    return long_options(getopt_long, "an:v::",
                        ARGUMENTS{"p", "in", "--size", "3", "--size=4", "-an", "5", "out", "-v", "-v2", NULL},
                        "s3 s4 a n5 v v2 <in><out>") &&
           long_options(getopt_long, "a", ARGUMENTS{"p", "x", "--level", "--lev=1", "--", "-a", "y", NULL},
                        "l l1 <x><-a><y>") &&
           long_options(getopt_long, "+a", ARGUMENTS{"p", "-a", "x", "-a", NULL}, "a <x><-a>") &&
           long_options(getopt_long, "-a", ARGUMENTS{"p", "x", "-a", "y", NULL}, "1x a 1y ") &&
           long_options(getopt_long, "a",
                        ARGUMENTS{"p", "--si=1", "--single", "--no", "--help=1", "-b", NULL}, "? 7 ? ? ? ") &&
           long_options(getopt_long, ":n:", ARGUMENTS{"p", "--size", NULL}, ": ") &&
           long_options(getopt_long, "n:", ARGUMENTS{"p", "-n", NULL}, "? ") &&
           long_options(getopt_long_only, "sn:", ARGUMENTS{"p", "-size", "1", "-s", "-n2", "-he", NULL},
                        "s1 s n2 h ");
}

static int lines(void)
{
    FILE *f = tmpfile();
    char *line = NULL;
    size_t size = 0;
    int good = 1;
    for (int n = 0; n < 300; n += 50)
        fprintf(f, "%0*d\n", n + 1, n);
    fprintf(f, "a;b");
    rewind(f);
    for (int n = 0; n < 300; n += 50)
        good = good && getline(&line, &size, f) == n + 2 && line[n + 1] == '\n' && atoi(line) == n &&
               !line[n + 2];
    good = good && getdelim(&line, &size, ';', f) == 2 && !strcmp(line, "a;") &&
           getline(&line, &size, f) == 1 && !strcmp(line, "b") && getline(&line, &size, f) == -1 && feof(f);
    free(line);
    fclose(f);
    return good;
}

/* The functions; with -O the header has macros. */
static int order_of_bytes(void)
{
    return (htonl)(0x01020304) == 0x04030201 && (ntohl)(0x01020304) == 0x04030201 &&
           (htons)(0x0102) == 0x0201 && (ntohs)(0x0102) == 0x0201;
}

static int signs(void)
{
    return lgamma(0.5) > 0.57 && signgam == 1 && lgamma(-0.5) > 1.26 && signgam == -1;
}

static int numbers(void)
{
    unsigned short seed[3] = {1, 2, 3};
    int point, sign;
    return atoll("123456789012") == 123456789012 && llabs(-3LL) == 3 &&
           !strcmp(ecvt(-12.5, 3, &point, &sign), "125") && point == 2 && sign && isnan(nan("")) &&
           fdim(3, 1) == 2 && erand48(seed) != erand48(seed) && llround(2.5) == 3 && ilogb(9.0) == 3 &&
           remainder(7, 4) == -1;
}

/* The next of the generator's numbers of 48 bits, as the standard says. */
static unsigned long long next_48(unsigned long long x, unsigned long long factor, unsigned addend)
{
    return (x * factor + addend) & 0xffffffffffff;
}

/* The state of drand48 and its kin: seeds, the state before, the caller's own state, other constants. */
static int random_48(void)
{
    const unsigned long long a = 0x5deece66d, x = next_48((1993 << 16) + 0x330e, a, 11),
                             y = next_48(x, a, 11);
    unsigned short own[3] = {0x330e, 1993, 0}, seed[3] = {5, 6, 7}, *before;
    unsigned short constants[7] = {1, 2, 3, 0x11, 0, 0, 9};
    srand48(1993);
    if (lrand48() != (long)(x >> 17) || mrand48() != (int)(y >> 16) || nrand48(own) != (long)(x >> 17) ||
        jrand48(own) != (int)(y >> 16))
        return 0;
    before = seed48(seed);
    if (before[0] != (y & 0xffff) || before[1] != (y >> 16 & 0xffff) || before[2] != y >> 32)
        return 0;
    double first = drand48(), same = (seed48(seed), drand48());
    lcong48(constants);
    return first == same && lrand48() == (long)(next_48(0x000300020001, 0x11, 9) >> 17);
}

/* The state of random lies in the program's arrays, between which it may change. */
static int random_states(void)
{
    static char one[128], two[32];
    char *first = initstate(1, one, sizeof one);
    long a = random(), b = random();
    if (a != 1804289383 || b != 846930886 || !first)
        return 0;
    if (initstate(1, two, sizeof two) != one)
        return 0;
    long other = random();
    int holds = setstate(one) == two && random() == 1681692777 && setstate(two) == one && random() != other;
    srandom(1);
    return holds && random() == other && setstate(first) == two && (srand(1), rand()) == 1804289383;
}

static int errors(void)
{
    char text[60] = "", few[4];
    return !strcmp(strerror(ENOENT), "No such file or directory") &&
           !strcmp(strerror_r(EBADF, text, sizeof text), "Bad file descriptor") &&
           __xpg_strerror_r(ENOENT, text, sizeof text) == 0 && !strcmp(text, strerror(ENOENT)) &&
           __xpg_strerror_r(ENOENT, few, sizeof few) == ERANGE && !few[3];
}

static int is_at(void *p, size_t align, size_t bytes)
{
    memset(p, 7, bytes);
    return (size_t)p % align == 0;
}

static int aligned(void)
{
    void *a = malloc(40), *b = aligned_alloc(64, 192), *c = memalign(4096, 1000), *d = valloc(10), *e = a;
    int good = posix_memalign(&e, 256, 77) == 0 && is_at(b, 64, 192) && is_at(c, 4096, 1000) &&
               is_at(e, 256, 77) && is_at(d, (size_t)getpagesize(), 10) &&
               posix_memalign(&a, 3, 8) == EINVAL && !posix_memalign(&d, 8, 8);
    free(b);
    b = realloc(c, 9000);
    good = good && b && ((char *)b)[999] == 7;
    free(a), free(b), free(d), free(e);
    return good;
}

/* libgen.h's, which change the path. */
static int parts_of(const char *path, const char *folder, const char *name)
{
    char a[20], b[20];
    return !strcmp(dirname(strcpy(a, path)), folder) && !strcmp(__xpg_basename(strcpy(b, path)), name);
}

static int parts_of_paths(void)
{
    return parts_of("/usr/lib", "/usr", "lib") && parts_of("/usr//", "/", "usr") &&
           parts_of("usr", ".", "usr") && parts_of("/", "/", "/") && parts_of("..", ".", "..") &&
           parts_of("", ".", ".") && parts_of("a//b//", "a", "b") && !strcmp(dirname(NULL), ".");
}

int main(void)
{
    rule("the calendar", calendar());
    rule("it begins in 1970", epoch());
    rule("the clock is in it", now());
    rule("div and its kin", divisions());
    rule("the locale is C", one_locale());
    rule("characters of several bytes", multibyte());
    rule("wide characters in files", wide_files());
    rule("fgetpos, fsetpos, setbuf", places());
    rule("vsscanf", scanning());
    rule("getopt", options());
    rule("getopt_long", options_of_several_letters());
    rule("getline", lines());
    rule("htonl and its kin", order_of_bytes());
    rule("signgam", signs());
    rule("numbers", numbers());
    rule("drand48 and its kin", random_48());
    rule("states of random", random_states());
    rule("errors have names", errors());
    rule("memory at multiples", aligned());
    rule("parts of paths", parts_of_paths());
    return 0;
}
