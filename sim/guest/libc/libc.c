/* libc.c - a node's part of the C library: its making, its end, and its small state. The node's
 * surroundings are in libc_system.c. A function node_NAME serves a node program's NAME and runs on the
 * node's stack. */
#include <assert.h>
#include <ctype.h>
#include <errno.h>
#include <langinfo.h>
#include <locale.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/crossing.h"
#include "kernel/xalloc.h"
#include "guest/heap.h"
#include "guest/image.h"
#include "guest/libc/libc_parts.h"
#include "node/node.h"
#include "node/self.h"
#include "os/end.h"
#include "os/fail.h"
#include "os/gate.h"
#include "nx_api/contract/error_text.h"

/* GNU's variables that hold the program's name, with the folders before it or without, and older names of
 * theirs. */
static const struct {
    const char *variable;
    bool is_short;
} program_names[PROGRAM_NAMES] = {{"program_invocation_name", false},
                                  {"program_invocation_short_name", true},
                                  {"__progname_full", false},
                                  {"__progname", true}};

static char **program_name(struct node *n, size_t i)
{
    char ***at = &libc_of(n)->program_names[i];
    if (!*at) {
        char *name = n->cold->argv[0], *slash = strrchr(name, '/');
        *at = own_memory_need(n, sizeof **at);
        **at = program_names[i].is_short && slash ? slash + 1 : name;
    }
    return *at;
}

void *node_libc_data(struct node *n, const char *name)
{
    if (strcmp(name, "environ") == 0)
        return node_libc_environ(n);
    if (strcmp(name, "stdin") == 0)
        return stream_variable(n, STDIN_FILENO);
    if (strcmp(name, "stdout") == 0)
        return stream_variable(n, STDOUT_FILENO);
    if (strcmp(name, "stderr") == 0)
        return stream_variable(n, STDERR_FILENO);
    for (size_t i = 0; i < PROGRAM_NAMES; i++)
        if (strcmp(name, program_names[i].variable) == 0)
            return program_name(n, i);
    return NULL;
}

char **node_libc_envp(struct node *n)
{
    return node_image_uses_environ(n->guest.file) ? *node_libc_environ(n) : n->cold->argv + n->cold->argc + 1;
}

void node_libc_flush(struct node *n)
{
    assert(node_is_self(n));
    if (n->guest.libc)
        streams_flush(&n->guest.libc->streams);
}

void node_libc_rescue(struct node *n)
{
    assert(!node_is_self(n));
    streams_rescue(&n->guest.libc->streams);
}

void node_libc_free(struct node *n)
{
    assert(!node_is_self(n));
    struct node_libc *c = n->guest.libc;
    if (!c)
        return;
    streams_close(&c->streams);
    descriptors_close(&c->descriptors);
    free(c->atexit);
    free(c->random);
    free(c->soft_limits);
    folder_free(c);
    node_libc_free_environment(c);
    own_memory_forget(&c->own);
    free(c);
    n->guest.libc = NULL;
}

/* --- ending --- */

int node_atexit(void (*f)(void))
{
    node_libc_at_end(node_self(), f);
    return 0;
}

void node_libc_at_end(struct node *n, void (*f)(void))
{
    struct node_libc *c = libc_of(n);
    c->atexit = xreallocarray(c->atexit, c->atexit_count + 1, sizeof *c->atexit);
    c->atexit[c->atexit_count++] = f;
}

/* Takes each function off the list before running it, so that the function may call exit() or atexit()
 * itself. */
static void run_atexit(struct node *n)
{
    struct node_libc *c = n->guest.libc;
    while (c && c->atexit_count > 0) {
        node_leave(n);
        crossing_call(c->atexit[--c->atexit_count], 0, 0, 0, 0, 0);
        node_enter(n, "exit");
    }
}

void node_libc_end(struct node *n)
{
    const void *block;
    run_atexit(n);
    node_libc_flush(n);
    size_t bytes = node_heap_check(n->guest.heap, &block);
    if (block)
        node_fail(n, "its heap is damaged: something was written before or after the %zu bytes at %p", bytes,
                  block);
}

_Noreturn void node_exit(int code)
{
    struct node *n = node_self();
    node_enter(n, "exit");
    node_libc_end(n);
    node_end_here(n, NODE_EXITED, code);
}

_Noreturn void node__exit(int code)
{
    struct node *n = node_self();
    node_enter(n, "_exit");
    node_end_here(n, NODE_EXITED, code);
}

_Noreturn void node__Exit(int code)
{
    node__exit(code);
}

/* abort(3) and assert(3) call f first, which calls the program's handler of SIGABRT
 * (nx_api/libc/signal_handlers.c). */
void node_nx_at_abort(void (*f)(void))
{
    libc_of(node_self())->at_abort = f;
}

static bool has_at_abort(struct node *n)
{
    return n->guest.libc && n->guest.libc->at_abort;
}

static void run_at_abort(struct node *n)
{
    if (has_at_abort(n))
        crossing_call(n->guest.libc->at_abort, 0, 0, 0, 0, 0);
}

_Noreturn void node_abort(void)
{
    struct node *n = node_self();
    run_at_abort(n);
    node_libc_flush(n);
    node_fail(n, "abort");
}

_Noreturn void node___assert_fail(const char *what, const char *file, unsigned line, const char *function)
{
    struct node *n = node_self();
    if (has_at_abort(n)) /* the handler may not return */
        fprintf(stream_standard(n, STDERR_FILENO), "%s:%u: %s: Assertion `%s' failed.\n", file, line,
                function, what);
    run_at_abort(n);
    node_libc_flush(n);
    node_fail(n, "%s:%u: %s: assertion '%s' failed", file, line, function, what);
}

_Noreturn void node___stack_chk_fail(void)
{
    node_fail(node_self(), "a function that ends wrote past the end of an array on its stack");
}

/* What raise(3) does that finds no handler (nx_api/libc/signal_handlers.c). */
_Noreturn void node_nx_ends_by(int number)
{
    struct node *n = node_self();
    node_libc_flush(n);
    node_fail(n, "raise: signal %d (%s) ends the program: it has no handler for it", number,
              strsignal(number));
}

/* --- random numbers, strtok, locale --- */

/* Every run gets equal numbers, each node its own, from a generator of the node's (splitmix64). */
int node_getentropy(void *buf, size_t bytes)
{
    uint64_t *state = &libc_of(node_self())->entropy;
    if (*state == 0)
        *state = (uint64_t)node_self()->id << 32;
    for (size_t i = 0; i < bytes; i++) {
        uint64_t z = *state += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        ((unsigned char *)buf)[i] = (unsigned char)(z >> 56);
    }
    return 0;
}

static struct random_numbers *numbers_of(struct node *n)
{
    struct node_libc *c = libc_of(n);
    if (!c->random) {
        c->random = xcalloc(1, sizeof *c->random);
        initstate_r(1, c->random->first_state, sizeof c->random->first_state, &c->random->random);
    }
    return c->random;
}

/* As in glibc, rand and random share one state. */
static struct random_data *random_of(struct node *n)
{
    return &numbers_of(n)->random;
}

long node_random(void)
{
    int32_t r;
    random_r(random_of(node_self()), &r);
    return r;
}

void node_srandom(unsigned seed)
{
    srandom_r(seed, random_of(node_self()));
}
int node_rand(void)
{
    return (int)node_random();
}
void node_srand(unsigned seed)
{
    node_srandom(seed);
}

double node_drand48(void)
{
    double r;
    drand48_r(&numbers_of(node_self())->drand48, &r);
    return r;
}

long node_lrand48(void)
{
    long r;
    lrand48_r(&numbers_of(node_self())->drand48, &r);
    return r;
}

void node_srand48(long seed)
{
    srand48_r(seed, &numbers_of(node_self())->drand48);
}

long node_mrand48(void)
{
    long r;
    mrand48_r(&numbers_of(node_self())->drand48, &r);
    return r;
}

double node_erand48(unsigned short x[3])
{
    double r;
    erand48_r(x, &numbers_of(node_self())->drand48, &r);
    return r;
}

long node_nrand48(unsigned short x[3])
{
    long r;
    nrand48_r(x, &numbers_of(node_self())->drand48, &r);
    return r;
}

long node_jrand48(unsigned short x[3])
{
    long r;
    jrand48_r(x, &numbers_of(node_self())->drand48, &r);
    return r;
}

/* Returns the state before, always at one place. */
unsigned short *node_seed48(unsigned short x[3])
{
    struct node *n = node_self();
    struct node_libc *c = libc_of(n);
    struct drand48_data *d = &numbers_of(n)->drand48;
    seed48_r(x, d);
    if (!c->seed48_before)
        c->seed48_before = own_memory_need(n, sizeof d->__old_x);
    return memcpy(c->seed48_before, d->__old_x, sizeof d->__old_x);
}

void node_lcong48(unsigned short parameters[7])
{
    lcong48_r(parameters, &numbers_of(node_self())->drand48);
}

/* The array that holds the state, which the program is about to be told: the first one moves to memory of the
 * program's own. */
static char *told_state(struct node *n)
{
    struct random_numbers *c = numbers_of(n);
    struct random_data *r = &c->random;
    if ((char *)(r->state - 1) == c->first_state) {
        char *to = own_memory_need(n, sizeof c->first_state);
        ptrdiff_t by = (int32_t *)memcpy(to, c->first_state, sizeof c->first_state) + 1 - r->state;
        r->state += by, r->fptr += by, r->rptr += by, r->end_ptr += by;
    }
    return (char *)(r->state - 1);
}

/* From now on, the state is the program's own array. Returns the array used before. */
char *node_initstate(unsigned seed, char *state, size_t bytes)
{
    struct node *n = node_self();
    char *before = told_state(n);
    return initstate_r(seed, state, bytes, random_of(n)) == 0 ? before : NULL;
}

char *node_setstate(char *state)
{
    struct node *n = node_self();
    char *before = told_state(n);
    return setstate_r(state, random_of(n)) == 0 ? before : NULL;
}

char *node_strtok(char *s, const char *delimiters)
{
    return strtok_r(s, delimiters, &libc_of(node_self())->strtok_next);
}

/* --- the locale: there is one, "C"; a program that asks for another gets this one --- */

enum { CTYPE_FIRST = -128, CTYPE_ENTRIES = 384 };

struct ctype_tables {
    const unsigned short *classes;
    const int *lower, *upper;
    unsigned short class_of[CTYPE_ENTRIES];
    int lower_of[CTYPE_ENTRIES], upper_of[CTYPE_ENTRIES];
};

static struct ctype_tables *tables(void)
{
    struct node *n = node_self();
    struct ctype_tables *t = libc_of(n)->ctype;
    if (t)
        return t;
    t = libc_of(n)->ctype = own_memory_need(n, sizeof *t);
    memcpy(t->class_of, *__ctype_b_loc() + CTYPE_FIRST, sizeof t->class_of);
    memcpy(t->lower_of, *__ctype_tolower_loc() + CTYPE_FIRST, sizeof t->lower_of);
    memcpy(t->upper_of, *__ctype_toupper_loc() + CTYPE_FIRST, sizeof t->upper_of);
    t->classes = t->class_of - CTYPE_FIRST;
    t->lower = t->lower_of - CTYPE_FIRST;
    t->upper = t->upper_of - CTYPE_FIRST;
    return t;
}

const unsigned short **node___ctype_b_loc(void)
{
    return &tables()->classes;
}

const int **node___ctype_tolower_loc(void)
{
    return &tables()->lower;
}

const int **node___ctype_toupper_loc(void)
{
    return &tables()->upper;
}

/* (Macros of the header look into it.) */
locale_t node_newlocale(int mask, const char *name, locale_t base)
{
    struct node *n = node_self();
    struct node_libc *c = libc_of(n);
    (void)mask, (void)name, (void)base;
    if (c->locale)
        return c->locale;
    c->locale = own_memory_need(n, sizeof *c->locale);
    c->locale->__ctype_b = tables()->classes;
    c->locale->__ctype_tolower = tables()->lower;
    c->locale->__ctype_toupper = tables()->upper;
    for (size_t i = 0; i < sizeof c->locale->__names / sizeof *c->locale->__names; i++)
        c->locale->__names[i] = own_memory_text(n, "C");
    return c->locale;
}

/* Glibc's items of its own, as libquadmath asks for, are words, not texts: the wide decimal point. */
char *node_nl_langinfo(nl_item item)
{
    enum { LEAST_ADDRESS = 1 << 16 };
    char *found = nl_langinfo(item);
    return (uintptr_t)found < LEAST_ADDRESS ? found : own_memory_text(node_self(), found);
}

locale_t node_uselocale(locale_t to)
{
    return node_newlocale(0, NULL, to);
}

void node_freelocale(locale_t l)
{
    (void)l;
}

/* --- errors and signals as texts --- */

char *node_strsignal(int number)
{
    const char *text = sigdescr_np(number);
    return own_memory_text(node_self(), text ? text : "Unknown signal");
}

char *node_strerror(int code)
{
    struct node *n = node_self();
    const char *text = nx_error_text(code);
    if (!text)
        text = strerrordesc_np(code);
    if (text)
        return own_memory_text(n, text);
    enum { ROOM = 64 };
    if (!libc_of(n)->unknown_error)
        libc_of(n)->unknown_error = own_memory_need(n, ROOM);
    snprintf(libc_of(n)->unknown_error, ROOM, "Unknown error %d", code);
    return libc_of(n)->unknown_error;
}

/* GNU's function; headers call POSIX's by the other name, below. */
char *node_strerror_r(int code, char *buf, size_t size)
{
    (void)buf, (void)size;
    return node_strerror(code);
}

int node___xpg_strerror_r(int code, char *buf, size_t size)
{
    const char *text = node_strerror(code);
    snprintf(buf, size, "%s", text);
    return strlen(text) < size ? 0 : ERANGE;
}

char *node_strerror_l(int code, locale_t l)
{
    (void)l;
    return node_strerror(code);
}
