/* objects.c - the table behind handles. */
#include <stdio.h>
#include <stdlib.h>
#include "lib.h"

READ_OFTEN static struct object **table;
READ_OFTEN static int used;
static int size;
static int first_free = -1; /* of those that are free: the next is in `next` */
static int *next;

struct nxm_library nxm_library = {true, &table, &used, &comm_world, &comm_self, basic_types};

void *get_memory(size_t bytes)
{
    void *p = bytes ? malloc(bytes) : NULL;
    if (bytes && !p)
        nxm_fail(CALL_Other, bytes > PTRDIFF_MAX ? "a count is negative"
                                                 : "the node has no memory left for MPI's library");
    return p;
}

static void grow(void)
{
    size = size ? 2 * size : 64;
    table = realloc(table, (size_t)size * sizeof *table);
    next = realloc(next, (size_t)size * sizeof *next);
    if (!table || !next)
        nxm_fail(CALL_Other, "the node has no memory left for MPI's handles");
}

static int take_place(void)
{
    if (first_free >= 0) {
        int place = first_free;
        first_free = next[place];
        return place;
    }
    if (used == size)
        grow();
    return used++;
}

void *object_new(enum kind kind, size_t bytes)
{
    struct object *o = calloc(1, bytes);
    if (!o)
        nxm_fail(CALL_Other, "the node has no memory left for MPI's objects");
    int place = take_place();
    table[place] = o;
    o->kind = kind, o->users = 1, o->handle = FIRST_HANDLE + place;
    return o;
}

RUN_OFTEN void *object_of(const void *handle, enum kind kind)
{
    uintptr_t place = (uintptr_t)handle - FIRST_HANDLE;
    if (place >= (uintptr_t)used)
        return NULL;
    struct object *o = table[place];
    return o && o->kind == kind ? o : NULL;
}

/* The object's handle is none any more. */
void object_end(struct object *o)
{
    int place = o->handle - FIRST_HANDLE;
    if (place >= 0 && place < used && table[place] == o) {
        table[place] = NULL;
        next[place] = first_free;
        first_free = place;
    }
}
