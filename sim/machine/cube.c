/* cube.c - see cube.h. */
#include "machine/cube.h"
#include <assert.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/xalloc.h"
#include "config/cube_type.h"
#include "lp/engine.h"
#include "guest/image.h"
#include "nx_api/include/nxerrno.h"
#include "machine/assemble.h"
#include "machine/debug_stop.h"
#include "os/end.h"
#include "os/fail.h"
#include "os/gate.h"
#include "os/match.h"
#include "races/race_check.h"

enum { ALL = -1, MOST_NAME = 32 };

struct program {
    char *argv[2]; /* the path of its file */
    struct node_image *image;
    struct program *next;
};

/* A node that another has succeeded. */
struct former {
    struct node *node;
    struct former *next;
};

struct cube {
    struct cube_options options;
    struct node_system *sys;
    bool there, asked_for; /* is there a cube? was it asked for, by getcube? */
    uint32_t largest;
    char name[MOST_NAME];
    struct program *programs;
    struct former *former;
};

static void set_count(struct cube *c, uint32_t count)
{
    c->sys->count = count;
    c->largest = count > c->largest ? count : c->largest;
    protocol_set_nodes(c->sys->schedule.protocol, count);
    if (c->sys->host)
        c->sys->host->id = count;
}

void cube_new(struct node_system *sys, const struct cube_options *options)
{
    assert(!sys->cube && options->most > 0);
    struct cube *c = xcalloc(1, sizeof *c);
    sys->nodes = xcalloc(options->most, sizeof *sys->nodes);
    c->sys = sys;
    c->options = *options;
    c->there = options->given;
    sys->cube = c;
    for (uint32_t i = 0; i < options->most; i++)
        sys->nodes[i] = node_new_empty(sys, i);
    set_count(c, options->given ? options->most : 0);
}

void cube_free(struct cube *c)
{
    if (!c)
        return;
    for (uint32_t i = 0; i < c->options.most; i++)
        node_delete(c->sys->nodes[i]);
    for (struct former *f = c->former, *next; f; f = next) {
        next = f->next;
        node_delete(f->node);
        free(f);
    }
    for (struct program *p = c->programs, *next; p; p = next) {
        next = p->next;
        node_image_close(p->image);
        free(p->argv[0]);
        free(p);
    }
    free(c);
}

static bool is_time(struct node *host, void *until)
{
    return node_now(host) >= *(vtime *)until;
}

/* The host waits for t, in the total order. Meanwhile nodes work, and the host's handlers run. */
static void take_time(struct node *host, vtime t)
{
    assert(host->is_host);
    node_order(host);
    vtime until = node_now(host) + t;
    lp_wake(&host->lp, until);
    node_wait(host, is_time, &until);
    node_order(host);
}

/* --- the cube --- */

uint32_t cube_most(const struct cube *c)
{
    return c->largest;
}

const char *cube_name(const struct cube *c)
{
    return c->there ? c->name : NULL;
}

static long no_cube(struct node *host)
{
    return node_error(host, EQNOPROC, "the host has no cube: getcube first, or touchstone run -n NODES");
}

static long check_name(struct node *host, const char *name)
{
    const struct cube *c = host->sys->cube;
    if (!c->there)
        return no_cube(host);
    if (name && *name && strcmp(name, c->name) && c->asked_for)
        return node_error(host, EINVAL, "there is no cube \"%s\": the host's is \"%s\"", name, c->name);
    return 0;
}

long cube_get(struct node *host, const char *name, const char *type)
{
    struct cube *c = host->sys->cube;
    struct cube_type t;
    name = name ? name : "";
    if (c->asked_for)
        return node_error(host, EBUSY, "the host has a cube already, \"%s\": relcube first", c->name);
    if (strlen(name) >= MOST_NAME)
        return node_error(host, EINVAL, "the name \"%s\" has more than %d letters", name, MOST_NAME - 1);
    char *wrong = cube_type_read(type, host->sys->cfg, c->options.most, &t);
    if (wrong) {
        node_error(host, EINVAL, "type \"%s\": %s", type, wrong);
        free(wrong);
        return -1;
    }
    if (t.nodes > c->options.most)
        return node_error(host, ENOSPC, "type \"%s\" asks for %u nodes, and there are %u%s", type, t.nodes,
                          c->options.most, c->options.given ? " (touchstone run -n)" : "");
    take_time(host, host->sys->cfg->host.cube_ps);
    c->there = c->asked_for = true;
    strcpy(c->name, name);
    set_count(c, t.nodes);
    return 0;
}

long cube_attach(struct node *host, const char *name)
{
    if (check_name(host, name) < 0)
        return -1;
    take_time(host, host->sys->cfg->host.cube_ps);
    return 0;
}

long cube_release(struct node *host, const char *name)
{
    struct cube *c = host->sys->cube;
    if (check_name(host, name) < 0)
        return -1;
    cube_kill(host, ALL, true);
    c->there = c->asked_for = false;
    set_count(c, 0);
    return 0;
}

/* --- its programs --- */

/* The path of a file in the host program's folder; malloc'd. */
static char *beside_host(const struct cube *c, const char *name)
{
    int dir = (int)(basename(c->options.host) - c->options.host);
    return xasprintf("%.*s%s", dir, c->options.host, name);
}

/* Finds the file that a host program means by `path`; malloc'd, NULL if there is none. The first choice is
 * the command line's node program, if the last part of its name is that of `path`; so paths of another
 * computer will do. Then come `path` as seen from the host program's folder, the file of that name in the
 * host program's folder, and `path` as seen from the current folder. */
static char *find_program(const struct cube *c, const char *path)
{
    const char *given = c->options.program;
    if (given && !strcmp(basename(given), basename(path)))
        return xstrdup(given);
    char *choice[] = {*path == '/' ? xstrdup(path) : beside_host(c, path), beside_host(c, basename(path)),
                      xstrdup(path)};
    char *found = NULL;
    for (int i = 0; i < 3; i++)
        if (!found && access(choice[i], R_OK) == 0)
            found = choice[i];
        else
            free(choice[i]);
    return found;
}

static struct program *open_program(struct node *host, const char *path)
{
    struct cube *c = host->sys->cube;
    char *error, *file = find_program(c, path);
    if (!file) {
        char *beside = beside_host(c, basename(path));
        node_error(host, ENOENT, "there is no program \"%s\": not from here, not %s, not on the command line",
                   path, beside);
        free(beside);
        return NULL;
    }
    for (struct program *p = c->programs; p; p = p->next)
        if (!strcmp(p->argv[0], file)) {
            free(file);
            return p;
        }
    struct node_image *image = node_image_open(file, &error);
    if (!image) {
        node_error(host, ENOEXEC, "%s", error);
        free(error);
        free(file);
        return NULL;
    }
    node_image_set_layer(image, node_image_layer(host->guest.file));
    struct program *p = xcalloc(1, sizeof *p);
    *p = (struct program){{file, NULL}, image, c->programs};
    return c->programs = p;
}

static long check_load(struct node *host, const char *path, long node, long pid)
{
    const struct node_system *s = host->sys;
    if (!s->cube->there)
        return no_cube(host);
    if (!path)
        return node_error(host, EQPBUF, "the program's name is a null pointer");
    if (pid < 0)
        return node_error(host, EQPID, "the process id %ld is negative", pid);
    if (node != ALL && (node < 0 || node >= (long)s->count))
        return node_error(host, EQNODE, "there is no node %ld (nodes are 0 to %u; -1 is all)", node,
                          s->count - 1);
    for (uint32_t i = 0; i < s->count; i++)
        if ((node == ALL || node == (long)i) && s->nodes[i]->lp.state != LP_ENDED)
            return node_error(host, EQUSEPID,
                              "node %u runs a program, and has room for one: wait for its end (waitall), or "
                              "killcube",
                              i);
    return 0;
}

static long load_one(struct node *host, struct program *p, uint32_t i, long pid)
{
    struct node_system *s = host->sys;
    struct node *before = s->nodes[i];
    char *error;
    struct node *n = node_new(s, i, p->image, 1, p->argv, s->cube->options.envp, &error);
    if (!n) {
        node_error(host, EQMEM, "%s", error);
        free(error);
        return -1;
    }
    struct former *f = xcalloc(1, sizeof *f);
    *f = (struct former){before, s->cube->former};
    s->cube->former = f;
    node_succeed(n, before, node_now(host));
    n->pid = pid;
    races_loaded(n, host);
    s->nodes[i] = n;
    s->running++;
    node_start(n, node_now(host));
    return 0;
}

long cube_load(struct node *host, const char *path, long node, long pid)
{
    if (check_load(host, path, node, pid) < 0)
        return -1;
    struct program *p = open_program(host, path);
    if (!p)
        return -1;
    const struct cfg_host *h = &host->sys->cfg->host;
    take_time(host, h->load_ps + node_image_load_bytes(p->image) * h->link_ps_per_byte);
    if (check_load(host, path, node, pid) < 0) /* a handler may have loaded something meanwhile */
        return -1;
    for (uint32_t i = 0; i < host->sys->count; i++)
        if ((node == ALL || node == (long)i) && load_one(host, p, i, pid) < 0)
            return -1;
    debug_stop_loaded(host->sys);
    return 0;
}

void cube_kill(struct node *caller, long node, bool flush)
{
    struct node_system *s = caller->sys;
    if (caller->is_host)
        take_time(caller, s->cfg->host.cube_ps);
    for (uint32_t i = 0; i < s->count; i++) {
        struct node *n = s->nodes[i];
        if ((node != ALL && node != (long)i) || n == caller)
            continue;
        node_end_other(caller, n);
        if (flush)
            match_empty(n, node_now(caller));
    }
}

long cube_check_send(struct node *host, long node)
{
    const struct node_system *s = host->sys;
    bool any = false;
    if (!s->cube->there)
        return no_cube(host);
    for (uint32_t i = 0; i < s->count; i++)
        any = any || ((node == ALL || node == (long)i) && s->nodes[i]->end.how != NODE_NOT_LOADED);
    if (any || node == (long)s->count)
        return 0;
    if (node == ALL)
        return node_error(host, EQNOPROC, "no node has a program: load one first");
    return node_error(host, EQNOPROC, "node %ld has no program: load one first", node);
}
