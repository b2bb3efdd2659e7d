/* What the C library keeps between calls, each node has for itself.
 * compile: -D_GNU_SOURCE
 * run: all
 */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#include "rule.h"

static char folder[100], name[100];

/* All have done the one half before any does the other. */
static int folders(void)
{
    char now[1000];
    FILE *f;
    mkdir(folder, 0777);
    int good = chdir(folder) == 0 && (f = fopen("here", "w")) != NULL && fprintf(f, "%ld", mynode()) > 0 &&
               fclose(f) == 0;
    gsync();
    long who = -1;
    f = fopen("./here", "r");
    good = good && f && fscanf(f, "%ld", &who) == 1 && who == mynode() && getcwd(now, sizeof now) &&
           strstr(now, folder) && chdir("nowhere") < 0 && chdir("..") == 0;
    good = good && snprintf(name, sizeof name, "%s/here", folder) > 0 && unlink(name) == 0;
    return rmdir(folder) == 0 && good;
}

int main(void)
{
    char text[40], value[40], *argv[] = {"p", "-a", "-b", NULL};
    time_t t = 86400 * (1000 + mynode());
    snprintf(folder, sizeof folder, "libc_apart.%ld.%d", mynode(), (int)getpid());

    char *stamp = ctime(&t), *expected = strdup(stamp);
    struct tm *tm = gmtime(&t);
    int day = tm->tm_yday;
    snprintf(text, sizeof text, "%ld,b,c", mynode());
    char *first = strtok(text, ",");
    snprintf(value, sizeof value, "NODE=%ld", mynode());
    putenv(value);
    setenv("OTHER", first, 1);
    for (long i = 0; i <= mynode() % 2; i++)
        getopt(3, argv, "ab");
    srand(mynode());
    int random = rand();
    gsync();
    rule("ctime", strcmp(stamp, expected) == 0);
    rule("gmtime", tm->tm_yday == day);
    char *second = strtok(NULL, ",");
    rule("strtok", second && !strcmp(second, "b"));
    rule("the environment", atol(getenv("NODE")) == mynode() && atol(getenv("OTHER")) == mynode());
    rule("unsetenv", unsetenv("OTHER") == 0 && !getenv("OTHER") && getenv("NODE"));
    rule("getopt", optind == 2 + mynode() % 2);
    srand(mynode());
    rule("rand", rand() == random);
    rule("the folder", folders());
    rule("a node is a process", getpid() > 0 && getppid() > 0 && getlogin() != expected);
    return 0;
}
