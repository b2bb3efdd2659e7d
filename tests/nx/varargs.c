/* varargs.h, as before 1989: arguments of all kinds, more than the registers hold, read twice and handed on.
 * compile: -w
 * run: all
 */
#include <stdio.h>
#include <varargs.h>
#include <nx.h>

char line[400];

int add(kinds, ap)
char *kinds;
va_list ap;
{
    double sum = 0;
    for (; *kinds; kinds++)
        sum = 3 * sum + (*kinds == 'd'   ? va_arg(ap, double)
                         : *kinds == 'l' ? va_arg(ap, long)
                         : *kinds == 's' ? strlen(va_arg(ap, char *))
                                         : va_arg(ap, int));
    return sum;
}

int total(va_alist) va_dcl
{
    va_list ap;
    char *kinds;
    int once, twice;
    va_start(ap);
    kinds = va_arg(ap, char *);
    once = add(kinds, ap);
    va_end(ap);
    va_start(ap);
    kinds = va_arg(ap, char *);
    twice = add(kinds, ap);
    va_end(ap);
    return once == twice ? once : -1;
}

say(va_alist) va_dcl
{
    va_list ap;
    char *format;
    va_start(ap);
    format = va_arg(ap, char *);
    vsprintf(line, format, ap);
    va_end(ap);
}

tell(va_alist) va_dcl
{
    va_list ap;
    char *format;
    va_start(ap);
    format = va_arg(ap, char *);
    _doprnt(format, ap, stdout);
    va_end(ap);
}

main()
{
    float f = 2.5;
    say("%d %s %g %c %ld", 1, "two", 3.5, 'c', 5L);
    if (mynode() == 0) {
        printf("%s\n", line);
        tell("%d %s %g\n", 6, "seven", 8.5);
        printf("%d\n", total("iiiiiiii", 1, 2, 3, 4, 5, 6, 7, 8));
        printf("%d\n", total("dddddddddd", 1., 2., 3., 4., 5., 6., 7., 8., 9., f));
        printf("%d %d\n", total("dilsdlis", 1., 2, 3L, "four", 5., 6L, 7, "eight..."), total(""));
    }
    return 0;
}
