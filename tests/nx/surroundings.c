/* What a node says of itself: its name, its machine, its one user, its clocks and alarms.
 * simulator only: the cluster's computers have names of their own
 * compile: -D_GNU_SOURCE -Wno-deprecated-declarations
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 * run: -m paragon -n 2
 */
#include <dlfcn.h>
#include <errno.h>
#include <malloc.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/times.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>
#include "rule.h"

/* A program that sleeps uses no time of the processor; one that computes does. */
static int times_used(void)
{
    struct rusage before, after;
    sleep(1);
    getrusage(RUSAGE_SELF, &before);
    double begin = dclock();
    for (volatile int i = 0; i < 100000; i++)
        ;
    double computed = dclock() - begin;
    sleep(1);
    getrusage(RUSAGE_SELF, &after);
    double user = (double)(after.ru_utime.tv_sec - before.ru_utime.tv_sec) +
                  1e-6 * (double)(after.ru_utime.tv_usec - before.ru_utime.tv_usec);
    return before.ru_utime.tv_sec == 0 && computed > 0.001 && user > 0.99 * computed && user < 1.1 * computed;
}

/* No signal is held back, and none is asked for: a program gets those only that end it. */
static int signals(void)
{
    struct sigaction now = {.sa_handler = SIG_IGN};
    sigset_t mask, held;
    sigfillset(&held);
    sigemptyset(&mask);
    sigaddset(&mask, SIGINT);
    return sigprocmask(SIG_BLOCK, &mask, &held) == 0 && !sigismember(&held, SIGINT) &&
           sigaction(SIGINT, NULL, &now) == 0 && now.sa_handler == SIG_DFL && sigblock(1) == 0 &&
           sigsetmask(0) == 0 && signal(SIGTERM, SIG_IGN) == SIG_DFL;
}

/* System V's calls are accepted, too; what waits for a signal ends with the alarm, or at once. */
static int system_v(void)
{
    double begin = dclock();
    alarm(2);
    int good = sigset(SIGINT, SIG_IGN) == SIG_DFL && !sigignore(SIGHUP) && !sighold(SIGTERM) &&
               !sigrelse(SIGTERM) && !siginterrupt(SIGINT, 1);
    good = good && pause() == -1 && errno == EINTR && dclock() - begin >= 2 && dclock() - begin < 2.1;
    return good && sigpause(SIGINT) == -1 && dclock() - begin < 2.1;
}

/* What the heap says of itself. */
static int heap_info(void)
{
    struct mallinfo before = mallinfo();
    char *volatile block = malloc(10000), *volatile last = malloc(10); /* they are not left out */
    struct mallinfo with = mallinfo();
    free(block);
    struct mallinfo after = mallinfo();
    int good = with.uordblks >= before.uordblks + 10010 && with.uordblks < before.uordblks + 10100 &&
               after.arena >= with.arena && after.uordblks <= with.uordblks - 10000 &&
               after.ordblks == before.ordblks + 1 && after.fordblks >= before.fordblks + 10000;
    free(last);
    struct mallinfo end = mallinfo();
    return good && end.uordblks == before.uordblks && end.arena == before.arena;
}

/* Each node's own, and the same in each run. */
static int entropy(void)
{
    unsigned char mine[8], next[8], last[8];
    if (getentropy(mine, 8) || getentropy(next, 8) || !memcmp(mine, next, 8))
        return 0;
    csend(1, mine, 8, next_node(), 0);
    crecv(1, last, 8);
    return memcmp(mine, last, 8) != 0 && (mynode() > 0 || mine[0] != 0 || mine[1] != 0);
}

/* The program is all that is loaded; it exports no names. */
static int loaded(void)
{
    Dl_info code, data, heap;
    static int variable;
    char *block = malloc(10);
    int good = dladdr((void *)loaded, &code) && dladdr(&variable, &data) && !dladdr(block, &heap) &&
               code.dli_fbase == data.dli_fbase && code.dli_fbase < (void *)loaded &&
               !memcmp(code.dli_fbase, "\177ELF", 4) && strstr(code.dli_fname, "surroundings") &&
               !code.dli_sname && !code.dli_saddr;
    free(block);
    return good;
}

/* A program has no children; and there are not as many clocks as numbers. */
static int wrong_clocks(void)
{
    struct rusage use;
    struct timespec now;
    struct timezone zone;
    int good = getrusage(RUSAGE_CHILDREN, &use) == 0 && !use.ru_utime.tv_sec && !use.ru_utime.tv_usec;
    good = good && getrusage(55, &use) == -1 && errno == EINVAL && gettimeofday(NULL, &zone) == 0;
    errno = 0;
    return good && clock_gettime(99, &now) == -1 && errno == EINVAL;
}

/* Names of variables that are none. */
static int wrong_names(void)
{
    int good = setenv("", "x", 1) == -1 && errno == EINVAL;
    errno = 0;
    good = good && setenv("A=B", "x", 1) == -1 && errno == EINVAL && !getenv("A");
    errno = 0;
    return good && unsetenv("A=B") == -1 && errno == EINVAL;
}

static int login(void)
{
    char name[40] = "", few[2];
    setenv("LOGNAME", "paul", 1);
    return !strcmp(getlogin(), "paul") && getlogin_r(name, sizeof name) == 0 && !strcmp(name, "paul") &&
           getlogin_r(few, sizeof few) == ERANGE;
}

int main(void)
{
    char domain[20] = "?", here[4096];
    struct utsname u;
    struct tms t;
    char name[40], expected[40], dir[300];
    snprintf(expected, sizeof expected, "node%ld", mynode());
    rule("gethostname", gethostname(name, sizeof name) == 0 && !strcmp(name, expected));
    rule("a name that does not fit", gethostname(name, 3) == -1 && errno == ENAMETOOLONG);
    rule("uname", uname(&u) == 0 && !strcmp(u.nodename, expected) && !strcmp(u.machine, "i860"));
    rule("getpid", getpid() == mynode() + 1 && getppid() == 1);
    rule("one user", getuid() == geteuid() && getgid() == getegid());
    rule("getcwd", getcwd(dir, sizeof dir) == dir && dir[0] == '/');
    rule("alarm", alarm(10) == 0 && sleep(3) == 0 && alarm(0) == 7 && alarm(0) == 0);
    rule("times", times(&t) >= 3 * sysconf(_SC_CLK_TCK) && t.tms_utime < sysconf(_SC_CLK_TCK));
    rule("a page", getpagesize() == 4096 && sysconf(_SC_PAGESIZE) == 4096);
    rule("the standard streams",
         fileno(stdin) == 0 && fileno(stdout) == 1 && fileno(stderr) == 2 && isatty(fileno(stdout)));
    rule("getdomainname", getdomainname(domain, sizeof domain) == 0 && !*domain);
    rule("gethostid", gethostid() == getpid() && getpgrp() == getpid());
    rule("getwd", getwd(here) == here && !strcmp(here, dir));
    rule("one process", nice(5) == 0 && sysconf(_SC_NPROCESSORS_ONLN) == 1);
    rule("files that may be open", getdtablesize() == sysconf(_SC_OPEN_MAX) && getdtablesize() > 20);
    rule("sysconf of something else", sysconf(12345) == -1 && errno == EINVAL);
    rule("getlogin", login());
    rule("getrusage", times_used());
    rule("clocks that are none", wrong_clocks());
    rule("variables that are none", wrong_names());
    rule("signals", signals());
    rule("System V's signals", system_v());
    rule("mallinfo", heap_info());
    rule("getentropy", entropy());
    rule("libraries", !dlopen("libm.so.6", RTLD_LAZY) && dlerror() && !dlerror() && !dlsym(NULL, "cos"));
    rule("what is loaded", loaded());
    return 0;
}
