/* lib.h - what the files of MPI's library share. The library is a part of the node program: nxcc compiles it,
 * what it computes is counted as the program's, and its variables are the rank's own.
 *
 *     point to point, requests, probes  --->  core (mpi_api/core): matching, waiting, sending
 *     collectives                       --->  coll.h: sends and receives in the other half of a context
 *     datatypes, groups, communicators, operations, topologies, attributes: here alone
 *
 * A handle is a number: of a constant of mpi.h, or of a place in the table of objects. So Fortran's handles
 * are C's.
 *
 * What each message needs is inline here, and its rare part a function elsewhere: the host predicts returns
 * wrongly behind a switch to another rank, and finds each rank's text at addresses of its own. */
#ifndef MPI_LIB_H
#define MPI_LIB_H
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include "mpi.h"
#include "mpi_api/core/core.h"
#include "mpi_api/core/library.h"

/* What each message runs and reads lies together: the fewer of a rank's pages a message touches, the less it
 * takes the host to find them (bench/speed/NOTES.md). */
#define RUN_OFTEN __attribute__((section(".text.hot")))
#define READ_OFTEN __attribute__((section(".data")))
#define RUN_SELDOM __attribute__((noinline))
#define USUALLY(x) __builtin_expect(!!(x), 1)
#define SELDOM(x) __builtin_expect(!!(x), 0)

/* A call, which programs reach by both of its names. By MPI_NAME it goes straight to PMPI_NAME, or by tell.S:
 * in code that nxcc does not compile, so that it takes no virtual time. */
#define CALL(name, parameters) BOTH_NAMES(".text", name) int PMPI_##name parameters
#define OFTEN_CALL(name, parameters) BOTH_NAMES(".text.hot", name) RUN_OFTEN int PMPI_##name parameters
#define BOTH_NAMES(text, name)                                                                               \
    __asm__(".pushsection " text "\n"                                                                        \
            ".weak MPI_" #name "\n"                                                                          \
            ".type MPI_" #name ", @function\n"                                                               \
            ".p2align 4\n"                                                                                   \
            "MPI_" #name ":\n"                                                                               \
            "    cmpb $0, nxm_library(%rip)\n"                                                               \
            "    je PMPI_" #name "\n"                                                                        \
            "    leaq 1f(%rip), %rax\n"                                                                      \
            "    leaq PMPI_" #name "(%rip), %r11\n"                                                          \
            "    jmp nxm_tell\n"                                                                             \
            ".size MPI_" #name ", .-MPI_" #name "\n"                                                         \
            ".section .rodata.str1.1, \"aMS\", @progbits, 1\n"                                               \
            "1:  .string \"MPI_" #name "\"\n"                                                                \
            ".popsection");

/* --- objects: mpi_api/core/library.h --- */

extern struct nxm_library nxm_library __attribute__((visibility("hidden")));

/* A new object, all 0, with one user, as the first member of a struct of so many bytes. */
void *object_new(enum kind kind, size_t bytes);
/* The object behind a handle; NULL: none of that kind. */
void *object_of(const void *handle, enum kind kind);
void object_end(struct object *o);
/* One user less. True: it was the last one; the handle is none any more, and the caller frees. */
static inline bool object_leave(struct object *o)
{
    if (--o->users > 0)
        return false;
    object_end(o);
    return true;
}
#define HANDLE(type, x) ((type)(intptr_t)(x)->object.handle)

void *get_memory(size_t bytes); /* malloc, or the end of the run; NULL for none */
/* Most messages have none: a call of free takes time, also for none. */
static inline void give_memory(void *p)
{
    if (p)
        free(p);
}

/* --- communicators --- */

static inline int group_node(const struct group *g, int rank)
{
    return SELDOM(g->nodes) ? g->nodes[rank] : g->first + rank;
}
int group_rank_in_list(const struct group *g, int node);
static inline int group_rank_of(const struct group *g, int node) /* MPI_UNDEFINED: none */
{
    if (SELDOM(g->nodes))
        return group_rank_in_list(g, node);
    return node >= g->first && node < g->first + g->size ? node - g->first : MPI_UNDEFINED;
}
struct group *group_new(int size);         /* with nodes to be filled in */
struct group *group_done(struct group *g); /* filled in */
struct group *group_keep(struct group *g); /* for one user more */
void group_leave(struct group *g);
int group_compare(const struct group *a, const struct group *b); /* MPI_IDENT, MPI_SIMILAR, MPI_UNEQUAL */
struct group *group_of(MPI_Group handle);

extern struct comm comm_world, comm_self;
extern bool mpi_runs;                               /* between MPI_Init and MPI_Finalize */
static inline struct comm *comm_of(MPI_Comm handle) /* NULL: none */
{
    if (SELDOM(!mpi_runs))
        return NULL;
    if (USUALLY(handle == MPI_COMM_WORLD))
        return &comm_world;
    return handle == MPI_COMM_SELF ? &comm_self : object_of(handle, COMM);
}
/* A new communicator of the group, which it takes over. */
struct comm *comm_new(struct group *local, struct group *remote, int context);
void comm_end(struct comm *c);
static inline void comm_leave(struct comm *c) /* one user less: of those under way, or the handle's */
{
    if (object_leave(&c->object))
        comm_end(c);
}
int comm_copy_attributes(struct comm *from, struct comm *to);
int comm_delete_attributes(struct comm *c);
struct topology *topology_copy(const struct topology *t);
void topology_free(struct topology *t);

/* --- errors --- */

/* Tells the communicator's error handler (NULL: that of MPI_COMM_WORLD); what the call returns. */
int fail(struct comm *c, int call, int code, const char *fmt, ...) __attribute__((format(printf, 4, 5)));
int fail_comm(int call);                   /* the communicator is none */
int fail_groups(struct comm *c, int call); /* the communicator is none, or has two groups */
int fail_answer(struct comm *c, int call); /* the pointer to where the answer goes is null */
/* As fail, by the error handler of another object; handle: where its handle is. */
int fail_by(MPI_Errhandler handler, void *handle, int call, int code, const char *fmt, va_list ap);
int error_last_code(void); /* the largest: the program may have added some */
/* An object's error handler is set; given to the program, which frees it; called by the program. */
int handler_set(int call, MPI_Errhandler *of, MPI_Errhandler handler);
MPI_Errhandler handler_get(MPI_Errhandler handler);
int handler_call(int call, MPI_Errhandler handler, void *handle, int code);

/* --- attributes: of any object, by a list of its own --- */

/* A new key; takes_numbers: its functions are Fortran's. */
int attribute_key(void *copy, void *drop, int *key, void *extra, bool takes_numbers);
int attribute_key_free(int call, int *key);
/* The hints of a file or window become a copy of info, or none (MPI_INFO_NULL); the program gets a copy of
 * them. */
int info_keep(MPI_Info *own, MPI_Info info);
int info_give(MPI_Info own, MPI_Info *info);
/* These return an error that the caller tells the handler of its object of; and the text for that. */
int attribute_set(void *handle, struct attribute **list, int key, void *value);
int attribute_get(struct attribute **list, int key, void *value, int *flag);
int attribute_delete(void *handle, struct attribute **list, int key);
int attribute_delete_all(void *handle, struct attribute **list);
const char *attribute_why(int code);
/* For Fortran: what was set last is a number; what C's call has got, as a number. */
void attribute_last_is_number(struct attribute *list);
MPI_Aint attribute_number(const struct attribute *list, const void *value);

/* --- datatypes --- */

extern struct basic basic_types[BASICS]; /* those with names are constant */
static inline const struct basic *type_basic(MPI_Datatype t)
{
    uintptr_t i = (uintptr_t)t - FIRST_BASIC;
    return i < BASICS && basic_types[i].class ? &basic_types[i] : NULL;
}
struct type *type_of(MPI_Datatype handle); /* NULL: none */
int type_missing(int call);                /* the datatype is none: what the call returns */
static inline MPI_Aint type_extent(const struct type *t)
{
    return t->ub - t->lb;
}
MPI_Aint extent_of(MPI_Datatype t);
size_t size_of(MPI_Datatype t);
int type_copy_attributes(struct type *from, struct type *to);
int type_delete_attributes(struct type *t);
void type_made_keep(MPI_Datatype t);
void type_made_leave(MPI_Datatype t);
bool type_made_is_valid(MPI_Datatype t);
static inline void type_keep(MPI_Datatype t) /* one user more: of those that are under way */
{
    if (!type_basic(t))
        type_made_keep(t);
}
static inline void type_leave(MPI_Datatype t)
{
    if (!type_basic(t))
        type_made_leave(t);
}
static inline bool type_is_valid(MPI_Datatype t) /* for communication: there, and committed */
{
    return USUALLY(type_basic(t)) || type_made_is_valid(t);
}

/* The bytes of `count` elements, in order: from memory, and into it, at most so many. */
void type_pack(const void *buf, int count, MPI_Datatype t, char *to);
void type_unpack(const char *from, size_t bytes, void *buf, int count, MPI_Datatype t);
void *type_made_together(const void *buf, int count, MPI_Datatype t, size_t *bytes);
/* Where the bytes lie, if they lie together; NULL: they do not. */
static inline void *type_together(const void *buf, int count, MPI_Datatype t, size_t *bytes)
{
    const struct basic *b = type_basic(t);
    if (SELDOM(!b || b->class == PAIR))
        return type_made_together(buf, count, t, bytes);
    *bytes = (size_t)count * b->bytes;
    return (void *)(uintptr_t)buf;
}
/* Reverses the bytes of each number of packed elements: external32's order. */
void type_reverse(MPI_Datatype t, char *packed, size_t bytes);
/* Copies elements of one type to those of another. */
void type_copy(const void *from, int count, MPI_Datatype t, void *to, int room, MPI_Datatype as);

/* --- point to point --- */

/* Sends and receives that have been checked. Of a rank's other half of the context: collectives'. */
struct transfer {
    int call;
    const void *buf;
    int count;
    MPI_Datatype type;
    int peer, tag; /* peer: a rank, MPI_PROC_NULL or MPI_ANY_SOURCE */
    MPI_Comm comm;
    enum mode mode;
    struct comm *c; /* set by transfer_check */
};
int transfer_check(struct transfer *t, bool sends);
/* The message has more bytes than there is room: an error. */
int message_too_long(struct comm *c, int call, const struct nxm_status *s, size_t room);
struct request *request_new(void);                                    /* all 0 */
struct request *transfer_begin(const struct transfer *t, bool sends); /* not under way yet */
void request_start(struct request *r);
/* The request is done, with this from the core. */
int request_finish(struct request *r, int call, const struct nxm_status *s, MPI_Status *status);
void request_drop(struct request *r);
/* Buffered sends: a copy of the data goes, if the attached buffer has room. */
int buffered_send(struct transfer *t);
void buffered_copy(const struct transfer *t); /* whether it has room or not */

void status_empty(MPI_Status *status);
static inline void status_set(MPI_Status *status, int source, int tag, size_t bytes)
{
    status->MPI_SOURCE = source, status->MPI_TAG = tag;
    status->MPI_internal[0] = (int)(bytes & 0xffffffff);
    status->MPI_internal[1] = (int)(bytes >> 32);
    status->MPI_internal[2] = 0;
}
size_t status_bytes(const MPI_Status *status);
/* Of a message that the core has told of. */
static inline void status_of(const struct comm *c, const struct nxm_status *s, MPI_Status *status)
{
    if (status)
        status_set(status, group_rank_of(c->peers, s->node), s->tag, (size_t)s->bytes);
}

/* --- operations --- */

struct op {
    struct object object;
    MPI_User_function *function;
    bool commutes;
};
/* inout = in op inout */
void op_apply(MPI_Op op, void *in, void *inout, int count, MPI_Datatype t);
bool op_commutes(MPI_Op op);
void op_keep(MPI_Op op); /* one user more: of those that are under way */
void op_leave(MPI_Op op);
bool op_is_own(MPI_Op op); /* one of MPI's, element by element */
/* NULL: the operation may be applied to the type; else why not. */
const char *op_refuses(MPI_Op op, MPI_Datatype t);

/* --- run --- */

extern long mpi_eager_limit;
extern bool mpi_of_1995; /* collectives are those of coll_1995.c */
void run_begin(void);

#endif
