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

/* The parameters as mpi_calls.h declares them: "(int *argc, char ***argv)". */
static const struct declared {
    const char *name, *parameters;
} declared[] = {
#define TEXT(...) #__VA_ARGS__
#define MPI_DECLARE(name, ...) {"MPI_" #name, TEXT(__VA_ARGS__)},
#include "mpi_api/include/mpi_calls.h"
#undef MPI_DECLARE
#undef TEXT
};

/* Pointers to the elements of `declared`, in order of their names. */
static const struct declared *sorted[sizeof declared / sizeof *declared];
static pthread_once_t once = PTHREAD_ONCE_INIT;

static int by_name(const void *a, const void *b)
{
    return strcmp((*(const struct declared *const *)a)->name, (*(const struct declared *const *)b)->name);
}

static void sort(void)
{
    for (size_t i = 0; i < sizeof sorted / sizeof *sorted; i++)
        sorted[i] = &declared[i];
    qsort(sorted, sizeof sorted / sizeof *sorted, sizeof *sorted, by_name);
}

static const struct declared *declared_as(const char *call)
{
    static const struct declared other = {"MPI", "()"};
    const struct declared key = {call, NULL}, *wanted = &key;
    pthread_once(&once, sort);
    const struct declared **found =
        bsearch(&wanted, sorted, sizeof sorted / sizeof *sorted, sizeof *sorted, by_name);
    return found ? *found : &other;
}

const char *told_name(const struct nxm_told *c)
{
    return declared_as(c->name)->name;
}

/* Is the parameter that ends at `end` called so? An array's name has [] behind it. */
static bool is_called(const char *end, const char *name)
{
    size_t length = strlen(name);
    while (end[-1] == ']' || end[-1] == '[')
        end--;
    return strncmp(end - length, name, length) == 0 && !isalnum((unsigned char)end[-(long)length - 1]) &&
           end[-(long)length - 1] != '_';
}

/* The place of a parameter; -1: there is none of that name. */
static int place_of(const char *parameters, const char *name)
{
    int place = 0;
    for (const char *p = parameters; *p; p++)
        if (*p == ',' || (*p == ')' && !p[1])) {
            if (is_called(p, name))
                return place;
            place++;
        }
    return -1;
}

static uintptr_t value_at(const struct nxm_told *c, int place)
{
    return place < 6 ? c->args[place] : c->more[place - 6];
}

bool told_argument(const struct nxm_told *c, const char *name, uintptr_t *value)
{
    int place = place_of(declared_as(c->name)->parameters, name);
    if (place < 0)
        return false;
    *value = value_at(c, place);
    return true;
}

uintptr_t *told_pointer(const struct nxm_told *c, const char *type)
{
    size_t length = strlen(type);
    int place = 0;
    for (const char *p = declared_as(c->name)->parameters; (p = strpbrk(p, "(,")); place++) {
        p += 1 + (p[1] == ' ');
        if (strncmp(p, type, length) == 0 && (p[length] == '*' || (p[length] == ' ' && p[length + 1] == '*')))
            return (uintptr_t *)value_at(c, place);
    }
    return NULL;
}

int told_int(const struct nxm_told *c, const char *name, int none)
{
    uintptr_t value;
    return told_argument(c, name, &value) ? (int)value : none;
}

void told_stem(const struct nxm_told *c, char stem[64])
{
    const char *name = c->name + sizeof "MPI_" - 1;
    snprintf(stem, 64, "%s", name);
    if (*name == 'I' && islower((unsigned char)name[1])) {
        snprintf(stem, 64, "%s", name + 1);
        *stem = (char)toupper((unsigned char)*stem);
    }
    char *end = stem + strlen(stem);
    if (end - stem > 5 && strcmp(end - 5, "_init") == 0)
        end[-5] = '\0';
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
