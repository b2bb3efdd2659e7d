/* libc_absent.c - functions of the C library, or others, that a node cannot have. They fail with ENOSYS,
 * and the run's report names those that a program called. */
#include <errno.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "guest/libc/host_errno.h"
#include "node/system.h"
#include "os/gate.h"
#include "node/self.h"

/* Does the function fail by returning NULL, not -1? A stub does not know its function's type. */
static bool returns_pointer(const char *name)
{
    static const char *const names[] = {
        "popen",         "fdopendir",      "gethostbyname", "gethostbyaddr", "gethostent", "getservbyname",
        "getservbyport", "getprotobyname", "getpwent",      "getgrnam",      "getgrgid",   "getpass",
        "dlopen",        "dlsym",          "dlerror",       "inet_ntoa",     "crypt",      "setmntent",
        "getmntent",     "fopencookie",    "inet_ntop"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(name, names[i]) == 0)
            return true;
    return false;
}

/* Notes a call of an absent function; called in the total order. */
static void note(struct node_system *sys, const char *function, const char *node)
{
    size_t i = 0;
    while (i < sys->absent_count && strcmp(sys->absent[i].function, function) != 0)
        i++;
    if (i == sys->absent_count) {
        sys->absent = xreallocarray(sys->absent, i + 1, sizeof *sys->absent);
        sys->absent[sys->absent_count++] = (struct node_absent){xstrdup(function), xstrdup(node), 0};
    }
    sys->absent[i].calls++;
}

static long absent(const char *name)
{
    struct node *n = node_self();
    node_enter(n, "a function that nodes do not have");
    note(n->sys, name, n->cold->name);
    node_leave(n);
    node_set_errno(ENOSYS);
    return returns_pointer(name) ? 0 : -1;
}

/* A node has no command processor. */
int node_system(const char *command)
{
    return command == NULL ? 0 : (int)absent("system");
}

/* Called by a program linked by nxcc --stubs in place of a function that does not exist:
 * nx_api/driver/stubs.c. */
long node_nx_absent(const char *name)
{
    return absent(name);
}
