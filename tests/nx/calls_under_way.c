/* backtrace, and the names of the program's calls: the innermost first, no more than asked for, those below
 * a handler, too.
 * simulator only: the cluster's C library is its own, and knows no static functions
 * again: --long32 --asan
 * run: all
 */
#include <execinfo.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "rule.h"

enum { MOST = 40 };
static void *calls[MOST];
static volatile int depth;

static __attribute__((noinline)) int inner(int most)
{
    depth = backtrace(calls, most);
    return depth;
}

static __attribute__((noinline)) int outer(int most)
{
    int found = inner(most);
    return found;
}

static int is(const char *name, const char *function)
{
    const char *begin = strchr(name, '(');
    return begin && strncmp(begin + 1, function, strlen(function)) == 0 &&
           begin[strlen(function) + 1] == '+' && strstr(name, ") [0x") != NULL;
}

static int names_them(void)
{
    int found = outer(MOST);
    char **names = backtrace_symbols(calls, found);
    int good = found >= 4 && is(names[0], "inner") && is(names[1], "outer") && is(names[2], "names_them") &&
               is(names[3], "main");
    free(names);
    return good;
}

static int no_more_than_asked_for(void)
{
    memset(calls, 0, sizeof calls);
    return outer(2) == 2 && calls[1] && !calls[2] && outer(0) == 0;
}

static int writes_them(void)
{
    char path[] = "callsXXXXXX", text[1000] = "";
    int file = mkstemp(path);
    outer(MOST);
    calls[1] = NULL;
    backtrace_symbols_fd(calls, 2, file);
    lseek(file, 0, SEEK_SET);
    int good = read(file, text, sizeof text - 1) > 0 && is(text, "inner") && strstr(text, "]\n[(nil)]\n");
    close(file);
    unlink(path);
    return good;
}

static void handler(long type, long bytes, long node, long pid)
{
    (void)type, (void)bytes, (void)node, (void)pid;
    outer(MOST);
}

static __attribute__((noinline)) void waits(void)
{
    long word = 0;
    depth = 0;
    hrecv(5, &word, sizeof word, handler);
    csend(5, &word, sizeof word, next_node(), 0);
    while (!depth)
        flick();
}

static int below_a_handler(void)
{
    int seen = 0;
    waits();
    char **names = backtrace_symbols(calls, depth);
    int good = is(names[0], "inner") && is(names[1], "outer") && is(names[2], "handler");
    for (int i = 3; i < depth; i++)
        seen |= is(names[i], "waits");
    free(names);
    return good && seen;
}

int main(void)
{
    rule("innermost first, with their names", names_them());
    rule("no more than asked for", no_more_than_asked_for());
    rule("into a file", writes_them());
    rule("in a handler", below_a_handler());
    return 0;
}
