/* grepper.c - grep: each node searches every so many lines of each file for an extended regular
 * expression; node 0 says how many lines there are. */
#include <err.h>
#include <regex.h>
#include <stdio.h>
#include <stdlib.h>
#include <nx.h>

int main(int argc, char **argv)
{
    regex_t re;
    char text[200], *line = NULL;
    size_t room = 0;
    long lines = 0, work;
    int error = argc < 3 ? REG_BADPAT : regcomp(&re, argv[1], REG_EXTENDED | REG_NEWLINE);
    if (error) {
        regerror(error, &re, text, sizeof text);
        errx(2, "%s", text);
    }
    for (int i = 2; i < argc; i++) {
        FILE *f = fopen(argv[i], "r");
        regmatch_t at;
        if (!f)
            err(2, "%s", argv[i]);
        for (long n = 0; getline(&line, &room, f) > 0; n++)
            if (n % numnodes() == mynode() && regexec(&re, line, 1, &at, 0) == 0) {
                printf("%s:%ld:%d: %s", argv[i], n + 1, (int)at.rm_so, line);
                lines++;
            }
        fclose(f);
    }
    free(line);
    regfree(&re);
    gisum(&lines, 1, &work);
    if (mynode() == 0)
        printf("%ld lines\n", lines);
    return 0;
}
