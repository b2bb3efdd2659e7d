/* The C library answers as the standard says: the calendar, divisions, the locale, characters of several
 * bytes, wide output.
 * compile: -D_GNU_SOURCE
 * run: all
 */
#include <limits.h>
#include <locale.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include <wchar.h>
#include "rule.h"

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
           !strcmp(asctime(&tm), "Tue Mar  2 01:00:00 1993\n") && strlen(ctime(&t)) == 25;
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
    return !strcmp(seen, "a b n3 x2 ") && optind == 6;
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
    rule("signgam", signs());
    rule("numbers", numbers());
    return 0;
}
