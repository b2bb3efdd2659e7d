/* told.c - see told.h: the beginning and the end of MPI's calls, and their arguments. */
#include "mpi_api/core/told.h"
#include <ctype.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "mpi_api/core/told_accesses.h"
#include "node/self.h"
#include "os/asan_hooks.h"
#include "os/observer.h"

/* --- names --- */

enum { MOST_PARAMETERS = 14, SLOTS = 2048 };

struct parameter {
    const char *name, *type; /* in the call's text; the type of a pointer, without "*" */
    size_t name_length, type_length;
};

/* A call. The parameters are text as mpi_calls.h declares them, "(int *argc, char ***argv)", and a list. */
static struct declared {
    const char *name, *text;
    struct parameter parameters[MOST_PARAMETERS];
    size_t count;
    char stem[32];
} declared[] = {
#define TEXT(...) #__VA_ARGS__
#define MPI_DECLARE(call, ...) {"MPI_" #call, TEXT(__VA_ARGS__), {{0}}, 0, ""},
#include "mpi_api/include/mpi_calls.h"
#undef MPI_DECLARE
#undef TEXT
};

/* The calls by a hash of their names; one that is taken sends to the next. */
static const struct declared *slots[SLOTS];
static pthread_once_t once = PTHREAD_ONCE_INIT;

/* (FNV-1a.) */
static size_t slot_of(const char *name)
{
    uint32_t hash = 0x811c9dc5;
    for (; *name; name++)
        hash = (hash ^ (unsigned char)*name) * 0x01000193;
    return hash % SLOTS;
}

/* "MPI_Comm *to": an array's name has [] behind it. */
static struct parameter parameter(const char *begin, const char *end)
{
    size_t length = strcspn(begin, " *,)");
    const char *behind = begin + length + (begin[length] == ' ');
    while (end[-1] == ']' || end[-1] == '[')
        end--;
    const char *name = end;
    while (isalnum((unsigned char)name[-1]) || name[-1] == '_')
        name--;
    return (struct parameter){name, begin, (size_t)(end - name), *behind == '*' ? length : 0};
}

static void list_parameters(struct declared *d)
{
    const char *begin = d->text + 1;
    for (const char *p = begin; *p; p++)
        if (*p == ',' || (*p == ')' && !p[1])) {
            d->parameters[d->count++] = parameter(begin, p);
            begin = p + 1 + (p[1] == ' ');
        }
}

static void find_stem(struct declared *d)
{
    const char *name = d->name + sizeof "MPI_" - 1;
    bool at_once = *name == 'I' && islower((unsigned char)name[1]);
    snprintf(d->stem, sizeof d->stem, "%s", name + at_once);
    *d->stem = (char)toupper((unsigned char)*d->stem);
    char *end = d->stem + strlen(d->stem);
    if (end - d->stem > 5 && strcmp(end - 5, "_init") == 0)
        end[-5] = '\0';
}

static void fill_slots(void)
{
    for (struct declared *d = declared; d < declared + sizeof declared / sizeof *declared; d++) {
        size_t slot = slot_of(d->name);
        list_parameters(d);
        find_stem(d);
        while (slots[slot])
            slot = (slot + 1) % SLOTS;
        slots[slot] = d;
    }
}

static const struct declared *declared_as(const char *call)
{
    static const struct declared other = {.name = "MPI", .text = "()"};
    pthread_once(&once, fill_slots);
    size_t slot = slot_of(call);
    while (slots[slot] && strcmp(slots[slot]->name, call) != 0)
        slot = (slot + 1) % SLOTS;
    return slots[slot] ? slots[slot] : &other;
}

const char *told_name(const struct nxm_told *c)
{
    return declared_as(c->name)->name;
}

const char *told_stem(const struct nxm_told *c)
{
    return declared_as(c->name)->stem;
}

static uintptr_t value_at(const struct nxm_told *c, size_t place)
{
    return place < 6 ? c->args[place] : c->more[place - 6];
}

bool told_argument(const struct nxm_told *c, const char *name, uintptr_t *value)
{
    const struct declared *d = declared_as(c->name);
    size_t length = strlen(name);
    for (size_t i = 0; i < d->count; i++)
        if (d->parameters[i].name_length == length && !memcmp(d->parameters[i].name, name, length)) {
            *value = value_at(c, i);
            return true;
        }
    return false;
}

uintptr_t *told_pointer(const struct nxm_told *c, const char *type)
{
    const struct declared *d = declared_as(c->name);
    size_t length = strlen(type);
    for (size_t i = 0; i < d->count; i++)
        if (d->parameters[i].type_length == length && !memcmp(d->parameters[i].type, type, length))
            return (uintptr_t *)value_at(c, i);
    return NULL;
}

int told_int(const struct nxm_told *c, const char *name, int none)
{
    uintptr_t value;
    return told_argument(c, name, &value) ? (int)value : none;
}

/* --- objects --- */

struct object *told_object(const struct nxm_library *l, uintptr_t handle, enum kind kind)
{
    uintptr_t place = handle - FIRST_HANDLE;
    struct object *o = place < (uintptr_t)*l->used ? (*l->table)[place] : NULL;
    return o && o->kind == kind ? o : NULL;
}

const struct basic *told_basic(const struct nxm_library *l, uintptr_t type)
{
    uintptr_t i = type - FIRST_BASIC;
    return i < BASICS && l->basics[i].class ? &l->basics[i] : NULL;
}

const struct type *told_type(const struct nxm_library *l, uintptr_t type)
{
    return (const struct type *)told_object(l, type, TYPE);
}

const struct comm *told_comm(const struct nxm_library *l, const struct nxm_told *c)
{
    uintptr_t handle;
    if (!told_argument(c, "comm", &handle))
        return NULL;
    return handle == (uintptr_t)MPI_COMM_WORLD  ? l->world
           : handle == (uintptr_t)MPI_COMM_SELF ? l->self
                                                : (struct comm *)told_object(l, handle, COMM);
}

/* --- beginning and end --- */

struct checked {
    struct node *n;
    const struct nxm_told *c;
    const void *frame;
};

static void check_access(void *ctx, const struct told_access *a)
{
    const struct checked *k = ctx;
    if (a->exact)
        asan_in_library(k->n, k->c->name, a->write, (const void *)a->at, a->bytes, k->frame);
}

void node_nxm_begins(const struct nxm_told *c, struct nxm_library *library);
void node_nxm_begins(const struct nxm_told *c, struct nxm_library *library)
{
    struct node *n = node_self();
    library->told = n->asan || IS_HEARD(n, library_begins);
    n->cold->mpi = library;
    if (n->asan)
        told_accesses(library, c, check_access, &(struct checked){n, c, __builtin_frame_address(0)});
    ANNOUNCE(n, library_begins, c, library);
}

void node_nxm_ends(const struct nxm_told *c, const struct nxm_library *library);
void node_nxm_ends(const struct nxm_told *c, const struct nxm_library *library)
{
    struct node *n = node_self();
    ANNOUNCE(n, library_ends, c, library);
}
