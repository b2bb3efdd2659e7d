/* cube_type.c - see cube_type.h. */
#include "config/cube_type.h"
#include <ctype.h>
#include <string.h>
#include "kernel/xalloc.h"

enum { MOST_NODES = 9999999 };

/* Reads a whole number of at most 7 digits. Returns false if there is none. */
static bool number(const char **at, uint32_t *value)
{
    int digits = 0;
    for (*value = 0; isdigit((unsigned char)**at) && digits < 7; digits++)
        *value = *value * 10 + (uint32_t)(*(*at)++ - '0');
    return digits > 0 && !isdigit((unsigned char)**at);
}

static char *read_size(const char **at, const struct cfg_machine *m, struct cube_type *t)
{
    bool dimension = **at == 'd', cube = m->topology == CFG_HYPERCUBE;
    *at += dimension;
    if (!number(at, &t->nodes) || (dimension && t->nodes > 30) || (!dimension && t->nodes == 0))
        return xasprintf("it begins with a number of nodes (16), or d and a dimension (d4)%s",
                         cube ? "" : ", or rows and columns (4x8)");
    if (dimension)
        t->nodes = UINT32_C(1) << t->nodes;
    if (**at == 'x' && !dimension && isdigit((unsigned char)(*at)[1])) {
        if (cube)
            return xasprintf("rows and columns are for a mesh, and %s is a hypercube", m->name);
        t->rows = t->nodes;
        ++*at;
        if (!number(at, &t->columns) || t->columns == 0)
            return xasprintf("rows and columns are numbers from 1 up");
        if ((uint64_t)t->rows * t->columns > MOST_NODES)
            return xasprintf("%u rows of %u nodes are more than any machine has", t->rows, t->columns);
        t->nodes = t->rows * t->columns;
    }
    if (cube)
        while (t->nodes & (t->nodes - 1))
            t->nodes += t->nodes & -t->nodes;
    return NULL;
}

static char *read_memory(const char **at, const struct cfg_machine *m)
{
    uint32_t mb;
    ++*at;
    if (!number(at, &mb))
        return xasprintf("m is followed by megabytes (4m16)");
    if (mb > m->memory_bytes >> 20)
        return xasprintf("the nodes of %s have %u MB", m->name, (unsigned)(m->memory_bytes >> 20));
    return NULL;
}

char *cube_type_read(const char *text, const struct cfg_machine *m, uint32_t all, struct cube_type *type)
{
    *type = (struct cube_type){.nodes = all};
    if (!text || !*text)
        return NULL;
    const char *at = text;
    char *error = read_size(&at, m, type);
    while (!error && *at) {
        if (*at == 'm')
            error = read_memory(&at, m);
        else if (!strncmp(at, "rx", 2))
            at += 2;
        else
            error = xasprintf("'%s' is no kind of node: all are i860s (rx), and m is their memory (m16)", at);
    }
    return error;
}
