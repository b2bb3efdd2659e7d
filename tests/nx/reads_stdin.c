/* The standard input goes to node 0; others find it at its end. Its calls read on where others have ended.
 * stdin: 12 monkeys and 3
 * run: all
 */
#include <stdarg.h>
#include <string.h>
#include "rule.h"

extern char *gets(char *);

static int read_by_list(const char *format, ...)
{
    va_list ap;
    va_start(ap, format);
    int count = vscanf(format, ap);
    va_end(ap);
    return count;
}

static int reads_on(void)
{
    char word[20] = "", line[20] = "";
    return getchar() == ' ' && getchar_unlocked() == 'a' && read_by_list("%19s", word) == 1 &&
           !strcmp(word, "nd") && gets(line) == line && !strcmp(line, " 3") && !gets(line);
}

int main(void)
{
    int n = 0, got;
    char word[20] = "";
    got = mynode() == 0 ? scanf("%d %19s", &n, word) : getchar();
    rule("node 0 reads it", mynode() != 0 || (got == 2 && n == 12 && word[6] == 's'));
    rule("in any way", mynode() != 0 || reads_on());
    rule("the others find nothing", mynode() == 0 || got == EOF);
    return 0;
}
