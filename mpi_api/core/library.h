/* library.h - what MPI's library (mpi_api/lib) keeps of a rank in the program's memory: its objects. The
 * library is their owner; those who check programs read them there. */
#ifndef MPI_LIBRARY_H
#define MPI_LIBRARY_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "mpi_api/core/core.h"
#include "mpi_api/include/mpi.h"

enum kind { NO_KIND, COMM, GROUP, TYPE, OP, REQUEST, ERRHANDLER, INFO, MESSAGE, FILE_OBJECT, WIN };

struct object {
    enum kind kind;
    int users, handle;
};

/* --- communicators --- */

struct group {
    struct object object;
    int size, rank; /* rank -1: the process is none of them */
    int first;      /* nodes NULL: rank r is node first + r */
    int *nodes;
};

struct attribute;

/* The grid or graph of a communicator. */
struct topology {
    int kind;         /* MPI_CART, MPI_GRAPH, MPI_DIST_GRAPH */
    int dims, *sides; /* of a grid */
    int *periods;
    int nodes, edge_count;
    int *ends, *edges; /* of a graph: rank r's neighbours are edges[ends[r - 1]] to before edges[ends[r]] */
    /* MPI_DIST_GRAPH: of the own rank; edges are those that lead to it */
    int outs, *dests;
    bool weighted;
    int *in_weights, *out_weights;
};

struct comm {
    struct object object;
    struct group *local, *remote; /* remote NULL: of one group */
    struct group *peers;          /* whom ranks of point to point name */
    int context;                  /* point to point; collectives: the next */
    MPI_Errhandler handler;
    int collectives; /* so many have begun: coll.h */
    struct attribute *attributes;
    struct topology *topology;
    char *name;
};

/* --- datatypes --- */

/* Bytes that lie together; elements of `unit` bytes. */
struct run {
    MPI_Aint at;
    size_t bytes;
    int unit;
};

struct type {
    struct object object;
    size_t size;
    MPI_Aint lb, ub, true_lb, true_ub;
    int align; /* of its members, as a C compiler does */
    int runs;
    struct run one, *run; /* run: &one, if there is one only */
    bool committed, has_lb, has_ub;
    int combiner, ints, addresses, types; /* of what it was made: Type_get_contents */
    int *int_list;
    MPI_Aint *address_list;
    MPI_Datatype *type_list;
    struct attribute *attributes;
    char *name;
};

enum basic_class { NO_TYPE, WHOLE, NATURAL, REAL, COMPLEX, LOGICAL, BITS, PAIR };
struct basic {
    uint8_t bytes, class; /* PAIR: a value and an int behind it, in so many bytes */
    uint8_t value;        /* PAIR: bytes of the value */
};
/* Datatypes of MPI's own: those with names, and behind them those that type_kinds.c makes. */
enum { FIRST_BASIC = 0x200, NAMED = 0xf2, MOST_KINDS = 128, BASICS = NAMED + MOST_KINDS };

/* --- requests --- */

enum mode { STANDARD, BUFFERED, SYNCHRONOUS, READY };

struct request {
    struct object object;
    enum { SENDS, RECEIVES, GENERAL, COLLECTS, MOVES } what;
    bool persistent, active;
    enum mode mode;
    int id;   /* the core's; 0: done */
    int peer; /* the other's rank */
    struct nxm_envelope envelope;
    struct comm *comm;
    void *buf, *packed; /* packed: instead of buf, while it is under way */
    int count;
    MPI_Datatype type;
    size_t room;
    MPI_Status status; /* if no message belongs to it */
    MPI_Grequest_query_function *query;
    MPI_Grequest_free_function *release;
    union {
        MPI_Grequest_cancel_function *cancel;
        /* A movement of a file under way has this: the function ends the movement, and sets this to NULL; or
         * finds that it goes on, unless it `waits`. */
        void (*end)(struct request *r, bool waits);
    };
    void *extra;
    struct task *task; /* of a collective */
    struct prepared *prepared;
};

/* --- windows --- */

struct remote {
    MPI_Aint size;
    int unit;
};

struct win_server;
struct access;
struct pending;
struct win {
    struct object object;
    struct comm *comm; /* its own */
    int flavor, unit;
    char *base;
    MPI_Aint size;
    bool allocated;        /* base is the window's own */
    struct remote *remote; /* of each rank */
    MPI_Errhandler handler;
    MPI_Info info;
    struct attribute *attributes;
    char *name;
    /* active */
    bool fenced;
    struct group *started, *posted;
    int missing;           /* ranks that have begun, and not completed */
    struct task *exposure; /* while posted: serves accesses */
    struct access *kept, **last_kept;
    /* passive */
    int *locked; /* of each rank: 0, or the kind of lock */
    int locks;   /* so many ranks are locked */
    bool all;    /* all ranks: each is locked when it is first accessed */
    struct win_server *server;
    struct pending *pending, **last_pending;
};

/* --- all of it --- */

/* Handles below are constants of mpi.h. */
enum { FIRST_HANDLE = 0x1000 };

/* Through this the simulator finds the objects. `told` comes first, for the stubs of CALL (lib.h). */
struct nxm_library {
    uint8_t told;           /* calls go by nxm_begins and nxm_ends; the simulator says so in the first */
    struct object ***table; /* *table has *used places, by handle - FIRST_HANDLE */
    const int *used;
    struct comm *world, *self;
    const struct basic *basics; /* BASICS of them, by handle - FIRST_BASIC */
};

/* A call of the program, before it begins or after it has ended: as tell.S leaves it on the stack. */
struct nxm_told {
    uintptr_t args[6]; /* the first arguments */
    const char *name;  /* "MPI_Send" */
    intptr_t result;
    const void *frame, *returns; /* the caller's, and where in the program */
    uintptr_t more[8];           /* the other arguments */
};
void nxm_begins(const struct nxm_told *c, struct nxm_library *library);
void nxm_ends(const struct nxm_told *c, const struct nxm_library *library);
#endif
