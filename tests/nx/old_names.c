/* Names that C libraries have no more, declared by the program itself: sys_errlist, sys_siglist, cfree.
 * compile: -w
 * again: --long32
 * run: all
 */
#include <signal.h>
#include <string.h>
#include "rule.h"

extern char *sys_errlist[], *sys_siglist[], *calloc();
extern int sys_nerr;

static int errors(void)
{
    int good = sys_nerr > 100;
    for (int i = 0; i < sys_nerr; i++)
        good = good && strcmp(sys_errlist[i], strerror(i)) == 0;
    return good;
}

static int signals(void)
{
    int good = 1;
    for (int i = 1; i < 32; i++)
        good = good && strcmp(sys_siglist[i], strsignal(i)) == 0;
    return good && sys_siglist[0] == 0;
}

static int blocks(void)
{
    char *block = calloc(10, 10);
    cfree(block, 10, 10);
    return block != 0;
}

int main(void)
{
    rule("sys_errlist", errors());
    rule("sys_siglist", signals());
    rule("cfree", blocks());
    return 0;
}
