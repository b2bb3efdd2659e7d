/* own_answers.c - what the C library and the system answer with by pointer is the node's own: it lies in
 * the node's memory, and what a node writes there, no other reads. It moves nothing that malloc gives.
 * simulator only: on MPI each node is a process
 * compile: -D_GNU_SOURCE -w
 * run: all
 */
#include <ctype.h>
#include <errno.h>
#include <locale.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include <zlib.h>
#include "rule.h"

enum { REGION_SHIFT = 30 };

static int is_own(const void *at)
{
    return (uintptr_t)at >> REGION_SHIFT == (uintptr_t)&at >> REGION_SHIFT;
}

/* Writes at a place, and finds the same there when all have. */
static void own(const char *text, void *at, size_t bytes)
{
    unsigned char *p = at, mark = 'a' + mynode() % 26;
    int kept = is_own(at);
    for (size_t i = 0; kept && i < bytes; i++)
        p[i] = mark;
    gsync();
    for (size_t i = 0; kept && i < bytes; i++)
        kept = p[i] == mark;
    rule(text, kept);
}

int main(int argc, char **argv, char **envp)
{
    static char state[64];
    unsigned short seed[3] = {1, 2, 3};
    char *first = malloc(10);
    free(first);
    rule("argv", argc == 1 && is_own(argv) && argv[argc] == NULL);
    rule("environ", is_own(envp) && is_own(environ) && is_own(environ[0]) && envp == environ);
    own("argv's text", argv[0], strlen(argv[0]));
    own("environ's text", environ[0], strlen(environ[0]));
    setenv("OWN", "answers", 1);
    own("getenv", getenv("OWN"), 7);
    rule("it is what is there", strlen(getenv("OWN")) == 7);
    rule("setenv many times", ({
             int ok = 1;
             for (int i = 0; i < 100000; i++)
                 ok = ok && !setenv("OWN", i % 2 ? "other" : "answers", 1);
             ok;
         }));
    environ[0] = NULL;
    rule("an emptied list", !getenv("OWN") && !setenv("OWN", "again", 0) && !strcmp(environ[0], "OWN=again"));

    char *absent = strerror(ENOENT), *denied = strerror(EACCES);
    rule("texts of errors",
         !strcmp(absent, "No such file or directory") && !strcmp(denied, "Permission denied"));
    own("strerror", absent, 5);
    own("strerror, unknown", strerror(12345), 10);
    own("getlogin", getlogin(), 1);
    srand48(mynode());
    double expected = drand48();
    srand48(mynode());
    own("seed48", seed48(seed), 6);
    srand48(mynode());
    rule("drand48", drand48() == expected);

    srandom(7);
    long a = random(), b = random(), c = random();
    srandom(7);
    random();
    char *old = initstate(1, state, sizeof state);
    rule("initstate", is_own(old));
    random();
    rule("setstate", setstate(old) == state && random() == b && random() == c && a != b);

    locale_t l = newlocale(LC_ALL_MASK, "C", NULL);
    rule("locale", is_own(l) && uselocale(NULL) == l && isalpha_l('x', l) && !isalpha_l('1', l));
    rule("ctype", is_own(__ctype_b_loc()) && is_own(*__ctype_b_loc()) && is_own(*__ctype_tolower_loc()) &&
                      is_own(*__ctype_toupper_loc()) && isdigit('7') && !isdigit('x') &&
                      toupper('a') == 'A' && isspace(' ') && isalpha(EOF) == 0);
    struct tm tm;
    time_t t = 0;
    gmtime_r(&t, &tm);
    rule("tm_zone", is_own(tm.tm_zone) && !strcmp(tm.tm_zone, "GMT"));
    rule("malloc's addresses", malloc(10) == first);
    return 0;
}
