/* Makes calls that nodes do not have; see stubs.sh. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>
#include <nx.h>

extern int gadget();

static void say(const char *what, long answer)
{
    if (mynode() == 0)
        printf("%s %ld%s\n", what, answer, errno == ENOSYS ? " ENOSYS" : "");
    errno = 0;
}

int main(int argc, char **argv)
{
    int (*pointer)() = gadget;
    say("fork", fork());
    say("fork", fork());
    if (mynode() == 1)
        socket(1, 2, 3);
    if (argc > 5)
        pipe(NULL);
    say("gadget", pointer(1, 2.5, argv));
    say("popen", (long)popen("ls", "r"));
    say("a command processor", system(NULL));
    say("system", system("ls"));
    return 0;
}
