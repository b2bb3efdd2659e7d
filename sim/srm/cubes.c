/* cubes.c - see cubes.h. */
#include "srm/cubes.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "srm/job.h"

void cubes_open(struct cubes *c, const struct cfg_machine *machine)
{
    *c = (struct cubes){.machine = machine};
    allocation_open(&c->allocation, machine);
}

void cubes_close(struct cubes *c)
{
    for (size_t i = 0; i < c->attached_count; i++)
        free(c->attached[i].session);
    free(c->attached);
    allocation_close(&c->allocation);
}

static uint8_t number_of(const struct cubes *c, const struct cube_entry *e)
{
    return (uint8_t)(e - c->list + 1);
}

const char *cubes_nodes(const struct cubes *c, const struct cube_entry *e, char *buf, size_t size)
{
    const struct allocation_piece *p = &e->piece;
    if (c->allocation.cube && p->nodes == 1)
        snprintf(buf, size, "node %u", p->column);
    else if (c->allocation.cube)
        snprintf(buf, size, "nodes %u to %u", p->column, p->column + p->nodes - 1);
    else
        snprintf(buf, size, "%u x %u nodes at row %u, column %u", p->rows, p->columns, p->row, p->column);
    return buf;
}

/* --- getting a cube --- */

static char *check_name(struct cubes *c, const char *name)
{
    if (!*name || strlen(name) >= CUBE_TEXT)
        return xasprintf("the name of a cube has 1 to %d characters, not \"%s\"", CUBE_TEXT - 1, name);
    for (const char *at = name; *at; at++)
        if (!isgraph((unsigned char)*at))
            return xasprintf("the name of a cube has no blanks: \"%s\"", name);
    for (int i = 0; i < CUBES_MOST; i++)
        if (c->list[i].used && !strcmp(c->list[i].name, name))
            return xasprintf("there is a cube \"%s\" already, of %s: getcube -c gives another name", name,
                             c->list[i].owner);
    return NULL;
}

/* The text, which is taken over, and behind it who has the nodes. */
static char *with_holders(const struct cubes *c, char *text)
{
    char nodes[80];
    for (int i = 0; i < CUBES_MOST; i++)
        if (c->list[i].used) {
            char *more = xasprintf("%s\n  %s of %s holds %s", text, c->list[i].name, c->list[i].owner,
                                   cubes_nodes(c, &c->list[i], nodes, sizeof nodes));
            free(text);
            text = more;
        }
    return text;
}

static char *not_free(const struct cubes *c, const struct cube_type *t)
{
    return with_holders(
        c, xasprintf("%u nodes are asked for; %u of %u are free, the largest %s of them %u:", t->nodes,
                     allocation_free(&c->allocation), allocation_all(&c->allocation),
                     c->allocation.cube ? "cube" : "rectangle", allocation_largest(&c->allocation)));
}

static char *no_entry(const struct cubes *c)
{
    return with_holders(
        c, xasprintf("there are %d cubes, which is all that the machine allows; relcube gives one back:",
                     CUBES_MOST));
}

struct cube_entry *cubes_get(struct cubes *c, const char *name, const char *type, const char *owner,
                             const char *session, char **error)
{
    struct cube_entry *e = c->list, *end = c->list + CUBES_MOST;
    struct cube_type t;
    if ((*error = check_name(c, name)))
        return NULL;
    while (e < end && e->used)
        e++;
    if (e == end)
        return *error = no_entry(c), NULL;
    char *wrong = strlen(type) < CUBE_TEXT
                      ? cube_type_read(type, c->machine, allocation_all(&c->allocation), &t)
                      : xasprintf("it is too long");
    if (wrong)
        return *error = xasprintf("type \"%s\": %s", type, wrong), free(wrong), NULL;
    if (!*type && !c->allocation.cube)
        t.rows = c->allocation.rows, t.columns = c->allocation.columns;
    if (!allocation_possible(&c->allocation, &t))
        return *error = xasprintf("type \"%s\": a %s of %u nodes does not fit in %s, a %s of %u", type,
                                  c->allocation.cube ? "cube" : "rectangle", t.nodes, c->machine->name,
                                  c->allocation.cube ? "hypercube" : "mesh", allocation_all(&c->allocation)),
               NULL;
    *e = (struct cube_entry){.since = time(NULL)};
    if (!allocation_take(&c->allocation, &t, number_of(c, e), &e->piece))
        return *error = not_free(c, &t), NULL;
    e->used = true;
    snprintf(e->name, sizeof e->name, "%s", name);
    snprintf(e->type, sizeof e->type, "%s", type);
    snprintf(e->owner, sizeof e->owner, "%s", owner);
    cubes_attach(c, e, session);
    return e;
}

/* --- sessions, and giving back --- */

static void detach(struct cubes *c, size_t i)
{
    free(c->attached[i].session);
    c->attached[i] = c->attached[--c->attached_count];
}

static struct attachment *attachment_of(const struct cubes *c, const char *session)
{
    for (size_t i = 0; i < c->attached_count; i++)
        if (!strcmp(c->attached[i].session, session))
            return &c->attached[i];
    return NULL;
}

void cubes_attach(struct cubes *c, struct cube_entry *e, const char *session)
{
    struct attachment *a = attachment_of(c, session);
    if (!a) {
        c->attached = xreallocarray(c->attached, c->attached_count + 1, sizeof *c->attached);
        a = &c->attached[c->attached_count++];
        a->session = xstrdup(session);
    }
    a->cube = number_of(c, e);
}

void cubes_release(struct cubes *c, struct cube_entry *e)
{
    allocation_give_back(&c->allocation, number_of(c, e));
    for (size_t i = c->attached_count; i-- > 0;)
        if (c->attached[i].cube == number_of(c, e))
            detach(c, i);
    free(e->program);
    *e = (struct cube_entry){0};
}

struct cube_entry *cubes_find(struct cubes *c, const char *name, const char *session, char **error)
{
    const struct attachment *a = attachment_of(c, session);
    struct cube_entry *only = NULL;
    int count = 0;
    if (!*name && a)
        return &c->list[a->cube - 1];
    for (int i = 0; i < CUBES_MOST; i++) {
        struct cube_entry *e = &c->list[i];
        if (e->used && *name && !strcmp(e->name, name))
            return e;
        count += e->used;
        only = e->used ? e : only;
    }
    if (!*name && count == 1)
        return only;
    if (count == 0)
        *error = xasprintf("there is no cube: getcube -t 16 gets one of 16 nodes");
    else if (*name)
        *error = xasprintf("there is no cube \"%s\": cubeinfo lists those there are", name);
    else
        *error = xasprintf(
            "which cube? There are %d, and this terminal is attached to none: -c NAME, or attachcube -c NAME",
            count);
    return NULL;
}

/* --- cubeinfo --- */

static void print_state(const struct cube_entry *e, FILE *f)
{
    if (!e->program)
        fprintf(f, "nothing loaded");
    else if (job_pid(e->job))
        fprintf(f, "%s, running for %ld s, process %d", e->program, (long)(time(NULL) - job_since(e->job)),
                (int)job_pid(e->job));
    else
        fprintf(f, "%s, ended with %d", e->program, job_status(e->job));
}

struct moment_text {
    char text[32];
};

static struct moment_text moment_text(time_t t, const char *form)
{
    struct moment_text m;
    struct tm tm;
    localtime_r(&t, &tm);
    strftime(m.text, sizeof m.text, form, &tm);
    return m;
}

static void print_cube(const struct cubes *c, const struct cube_entry *e, bool attached, FILE *f)
{
    char nodes[80];
    fprintf(f, "%c %-12s %-6s %-16s %-10s %s  ", attached ? '*' : ' ', e->name, *e->type ? e->type : "all",
            cubes_nodes(c, e, nodes, sizeof nodes), e->owner,
            moment_text(e->since, "%Y-%m-%d %H:%M:%S").text);
    print_state(e, f);
    fputc('\n', f);
}

void cubes_print(const struct cubes *c, const char *session, FILE *f)
{
    const struct attachment *a = attachment_of(c, session);
    int count = 0;
    for (int i = 0; i < CUBES_MOST; i++)
        count += c->list[i].used;
    if (count)
        fprintf(f, "  %-12s %-6s %-16s %-10s %-19s  %s\n", "cube", "type", "nodes", "owner", "since",
                "program");
    for (int i = 0; i < CUBES_MOST; i++)
        if (c->list[i].used)
            print_cube(c, &c->list[i], a && a->cube == i + 1, f);
    fprintf(f, "%s: %d of %d cubes; %u of %u nodes free, the largest %s %u\n", c->machine->name, count,
            CUBES_MOST, allocation_free(&c->allocation), allocation_all(&c->allocation),
            c->allocation.cube ? "cube" : "rectangle", allocation_largest(&c->allocation));
}

static json_t *state_json(const struct cube_entry *e)
{
    if (!e->program)
        return json_null();
    json_t *o = xchecked(json_pack("{s:o, s:s}", "command", json_text(e->program), "since",
                                   moment_text(job_since(e->job), "%Y-%m-%dT%H:%M:%S%z").text));
    if (job_pid(e->job))
        json_set(o, "process", json_integer(job_pid(e->job)));
    else
        json_set(o, "exit_status", json_integer(job_status(e->job)));
    return o;
}

static json_t *cube_json(const struct cube_entry *e, bool attached)
{
    const struct allocation_piece *p = &e->piece;
    return xchecked(json_pack("{s:s, s:b, s:s, s:i, s:i, s:i, s:i, s:i, s:o, s:s, s:o}", "name", e->name,
                              "attached", attached, "type", *e->type ? e->type : "all", "nodes",
                              (int)p->nodes, "row", (int)p->row, "column", (int)p->column, "rows",
                              (int)p->rows, "columns", (int)p->columns, "owner", json_text(e->owner), "since",
                              moment_text(e->since, "%Y-%m-%dT%H:%M:%S%z").text, "program", state_json(e)));
}

json_t *cubes_json(const struct cubes *c, const char *session)
{
    const struct attachment *a = attachment_of(c, session);
    json_t *list = xchecked(json_array());
    for (int i = 0; i < CUBES_MOST; i++)
        if (c->list[i].used)
            json_append(list, cube_json(&c->list[i], a && a->cube == i + 1));
    return xchecked(json_pack(
        "{s:s, s:s, s:i, s:i, s:i, s:i, s:o}", "format", "touchstone cubes 1", "machine", c->machine->name,
        "nodes", (int)allocation_all(&c->allocation), "free", (int)allocation_free(&c->allocation), "largest",
        (int)allocation_largest(&c->allocation), "most_cubes", CUBES_MOST, "cubes", list));
}
