/* libc_system.c - what a program learns of its surroundings: names and numbers of the node, the
 * environment, signals. The answers are equal on every computer, except for the environment, which is the
 * user's. A function node_NAME serves a node program's NAME. */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>
#include <unistd.h>
#include "kernel/xalloc.h"
#include "guest/libc/libc_parts.h"
#include "node/node.h"
#include "node/system.h"
#include "node/self.h"
#include "os/front.h"
#include "os/gate.h"
#include "os/memory.h"

/* --- names and numbers --- */

/* A call that UNIX answers: by a server, where NX is a library above a kernel. */
static void unix_call(const char *call)
{
    struct node *n = node_self();
    vtime takes = n->sys->cfg->unix_call_ps;
    if (!takes)
        return;
    node_enter(n, call);
    node_spend(n, takes);
    node_leave(n);
}

/* Writes "node3": programs make names of files of it, so it has no blanks. */
static void host_name(char *buf, size_t size)
{
    const struct node *n = node_self();
    if (n->is_host)
        snprintf(buf, size, "host");
    else
        snprintf(buf, size, "node%u", n->id);
}

int node_gethostname(char *buf, size_t size)
{
    char name[sizeof((struct utsname *)0)->nodename];
    unix_call("gethostname");
    host_name(name, sizeof name);
    if (size > 0)
        snprintf(buf, size, "%s", name);
    if (strlen(name) < size)
        return 0;
    errno = ENAMETOOLONG;
    return -1;
}

/* A node has no domain: the name is empty. */
int node_getdomainname(char *buf, size_t size)
{
    if (size > 0)
        *buf = 0;
    return 0;
}

long node_gethostid(void)
{
    return (long)node_self()->id + 1;
}

int node_uname(struct utsname *u)
{
    unix_call("uname");
    *u = (struct utsname){.sysname = "NX", .release = "1", .version = "touchstone", .machine = "i860"};
    host_name(u->nodename, sizeof u->nodename);
    return 0;
}

int node_getpid(void)
{
    unix_call("getpid");
    return (int)node_self()->id + 1;
}

/* Beside the program there is one process, the system's. */
int node_getppid(void)
{
    unix_call("getppid");
    return 1;
}

int node_getpgrp(void)
{
    return node_getpid();
}

/* There is one user, in one group. */
static int user_id(void)
{
    unix_call("getuid");
    return 100;
}
uid_t node_getuid(void)
{
    return (uid_t)user_id();
}
uid_t node_geteuid(void)
{
    return (uid_t)user_id();
}
gid_t node_getgid(void)
{
    return (gid_t)user_id();
}
gid_t node_getegid(void)
{
    return (gid_t)user_id();
}

int node_nice(int by)
{
    (void)by; /* a node runs one process */
    unix_call("nice");
    return 0;
}

/* The page size of the i860. */
int node_getpagesize(void)
{
    return 4096;
}

int node_getdtablesize(void)
{
    return NODE_DESCRIPTORS;
}

long node_sysconf(int name)
{
    switch (name) {
    case _SC_CLK_TCK:
        return sysconf(_SC_CLK_TCK); /* as the header says; times() counts in it */
    case _SC_PAGESIZE:
        return node_getpagesize();
    case _SC_OPEN_MAX:
        return NODE_DESCRIPTORS;
    case _SC_NPROCESSORS_CONF:
    case _SC_NPROCESSORS_ONLN:
        return 1;
    case _SC_MINSIGSTKSZ: /* the host's sizes depend on its processor */
        return 2048;
    case _SC_SIGSTKSZ:
        return 8192;
    case _SC_PHYS_PAGES:
    case _SC_AVPHYS_PAGES:
        return (long)(node_memory_limit(node_self()) / (size_t)node_getpagesize());
    default:
        errno = EINVAL;
        return -1;
    }
}

/* --- limits: the machine sets the hard one; the soft one is the program's to set, and to read --- */

static rlim_t hard_limit(const struct node *n, int what)
{
    switch (what) {
    case RLIMIT_DATA:
    case RLIMIT_AS:
    case RLIMIT_RSS:
        return node_memory_limit(n);
    case RLIMIT_STACK:
        return n->sys->cfg->stack_bytes;
    case RLIMIT_NOFILE:
        return NODE_DESCRIPTORS;
    case RLIMIT_NPROC:
        return 1;
    case RLIMIT_CORE:
    case RLIMIT_MEMLOCK:
        return 0;
    default:
        return RLIM_INFINITY;
    }
}

int node_getrlimit(int what, struct rlimit *l)
{
    struct node *n = node_self();
    if (what < 0 || what >= RLIM_NLIMITS) {
        errno = EINVAL;
        return -1;
    }
    const rlim_t *soft = libc_of(n)->soft_limits;
    l->rlim_max = hard_limit(n, what);
    l->rlim_cur = soft ? soft[what] : l->rlim_max;
    return 0;
}

int node_setrlimit(int what, const struct rlimit *l)
{
    struct node *n = node_self();
    struct rlimit now;
    if (node_getrlimit(what, &now) != 0)
        return -1;
    if (l->rlim_cur > l->rlim_max || l->rlim_max > now.rlim_max) {
        errno = l->rlim_cur > l->rlim_max ? EINVAL : EPERM;
        return -1;
    }
    struct node_libc *c = libc_of(n);
    if (!c->soft_limits) {
        c->soft_limits = xcalloc(RLIM_NLIMITS, sizeof *c->soft_limits);
        for (int i = 0; i < RLIM_NLIMITS; i++)
            c->soft_limits[i] = hard_limit(n, i);
    }
    c->soft_limits[what] = l->rlim_cur;
    return 0;
}

/* --- the environment: what the user has given, copied for the program when it first asks for something
 * that is there --- */

static char **find_in(char **list, const char *name, size_t len)
{
    char **e = list;
    while (e != NULL && *e != NULL && (**e != *name || strncmp(*e, name, len) != 0 || (*e)[len] != '='))
        e++;
    return e != NULL && *e != NULL ? e : NULL;
}

static size_t count_variables(char *const *list)
{
    size_t count = 0;
    while (list != NULL && list[count] != NULL)
        count++;
    return count;
}

/* A list of the program's own with the variables of `from`, and room for one more. */
static char **list_with_room(struct node *n, char **from)
{
    struct node_libc *c = libc_of(n);
    size_t count = count_variables(from), needed = count + 2;
    if (from == c->environment && needed <= c->environment_room)
        return from;
    size_t room = 2 * needed;
    char **list = own_memory_take(n, room * sizeof *list);
    if (!list)
        return NULL;
    if (count > 0)
        memcpy(list, from, count * sizeof *list);
    c->environment_room = room;
    return c->environment = list;
}

char ***node_libc_environ(struct node *n)
{
    struct node_libc *c = libc_of(n);
    if (c->environ_at)
        return c->environ_at;
    c->environ_at = own_memory_need(n, sizeof *c->environ_at);
    char **list = list_with_room(n, n->cold->envp);
    for (char **e = list; e && *e; e++) {
        size_t bytes = strlen(*e) + 1;
        *e = memcpy(own_memory_need(n, bytes), *e, bytes);
    }
    *c->environ_at = list;
    return c->environ_at;
}

char *node_getenv(const char *name)
{
    struct node *n = node_self();
    size_t len = strlen(name);
    if (!libc_of(n)->environ_at && !find_in(n->cold->envp, name, len))
        return NULL;
    char **e = find_in(*node_libc_environ(n), name, len);
    return e ? *e + len + 1 : NULL;
}

char *node_secure_getenv(const char *name)
{
    return node_getenv(name);
}

static int put_variable(struct node *n, char *text, size_t name_len)
{
    char ***at = node_libc_environ(n), **list = list_with_room(n, *at);
    if (list == NULL) {
        errno = ENOMEM;
        return -1;
    }
    *at = list;
    char **e = find_in(list, text, name_len);
    if (e == NULL)
        e = list + count_variables(list);
    *e = text;
    return 0;
}

/* A variable's name has a letter at least, and no '='. */
static bool is_name(const char *name)
{
    if (*name && !strchr(name, '='))
        return true;
    errno = EINVAL;
    return false;
}

int node_unsetenv(const char *name)
{
    if (!is_name(name))
        return -1;
    char **list = *node_libc_environ(node_self());
    size_t len = strlen(name);
    for (char **e; (e = find_in(list, name, len)) != NULL;)
        for (; *e != NULL; e++)
            *e = e[1];
    return 0;
}

int node_putenv(char *text)
{
    const char *equals = strchr(text, '=');
    if (!equals)
        return node_unsetenv(text);
    return put_variable(node_self(), text, (size_t)(equals - text));
}

struct set_text {
    char *text;
    size_t room;
};

/* A text of so many bytes: that of a variable which setenv has made before, if it has the room. */
static char *text_to_set(struct node *n, const char *before, size_t bytes)
{
    struct node_libc *c = libc_of(n);
    for (size_t i = 0; before && i < c->set_count; i++)
        if (c->set[i].text == before && c->set[i].room >= bytes)
            return c->set[i].text;
    char *text = own_memory_take(n, bytes);
    if (text == NULL) {
        errno = ENOMEM;
        return NULL;
    }
    c->set = xreallocarray(c->set, c->set_count + 1, sizeof *c->set);
    c->set[c->set_count++] = (struct set_text){text, bytes};
    return text;
}

int node_setenv(const char *name, const char *value, int replaces)
{
    struct node *n = node_self();
    if (!is_name(name))
        return -1;
    size_t len = strlen(name), bytes = len + strlen(value) + 2;
    char **e = find_in(*node_libc_environ(n), name, len);
    if (!replaces && e != NULL)
        return 0;
    char *text = text_to_set(n, e ? *e : NULL, bytes);
    if (text == NULL)
        return -1;
    snprintf(text, bytes, "%s=%s", name, value);
    return put_variable(n, text, len);
}

void node_libc_free_environment(struct node_libc *c)
{
    free(c->set);
}

/* The user's name, as the environment has it. */
static const char *login(void)
{
    const char *name = node_getenv("LOGNAME");
    if (name == NULL)
        name = node_getenv("USER");
    return name ? name : "nx";
}

char *node_getlogin(void)
{
    return own_memory_text(node_self(), login());
}

int node_getlogin_r(char *buf, size_t size)
{
    if (strlen(login()) >= size)
        return ERANGE;
    strcpy(buf, login());
    return 0;
}

/* --- masks of signals: none comes that a mask could hold back (nx_api/libc/signal_handlers.c) --- */

int node_sigprocmask(int how, const sigset_t *mask, sigset_t *before)
{
    (void)how, (void)mask;
    if (before != NULL)
        sigemptyset(before);
    return 0;
}

int node_sigblock(int mask)
{
    (void)mask;
    return 0;
}

int node_sigsetmask(int mask)
{
    (void)mask;
    return 0;
}

/* --- System V's, which programs use in their place --- */

int node_sighold(int number)
{
    (void)number;
    return 0;
}

int node_sigrelse(int number)
{
    (void)number;
    return 0;
}

int node_siginterrupt(int number, int ends_calls)
{
    (void)number, (void)ends_calls;
    return 0;
}
