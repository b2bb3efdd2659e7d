/* What a node says of itself: its name, its machine, its one user, its clocks and alarms.
 * simulator only: the cluster's computers have names of their own
 * run: -m ipsc860 -n 2
 * run: -m delta -n 2
 * run: -m paragon -n 2
 */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/times.h>
#include <sys/utsname.h>
#include <unistd.h>
#include "rule.h"

int main(void)
{
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
    return 0;
}
