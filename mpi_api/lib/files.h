/* files.h - MPI's files: an open file of a communicator, and what a rank sees of it.
 *
 *   calls           files.c          opening, sizes, hints, error handlers
 *                   file_moves.c     reading and writing: at places, at the rank's pointer, at the shared one
 *   view            file_views.c     which bytes of the file the rank sees, in order
 *                   datareps.c       what stands for a number there
 *   shared pointer  file_server.c    rank 0 has it, and the lock of atomic mode
 *   bytes           core.h           movements, in the time of the file system that the name belongs to
 *
 * Data are one range of bytes in memory, packed if they do not lie together, and pieces of the file, which
 * are moved one after the other. Collective calls move each rank's own pieces. */
#ifndef MPI_FILES_H
#define MPI_FILES_H
#include "coll.h"

struct file {
    struct object object;
    struct comm *comm; /* its own */
    int fd, amode;
    char *name;
    MPI_Info info;
    MPI_Errhandler handler;
    MPI_Offset displacement; /* the view */
    MPI_Datatype etype, filetype;
    const struct datarep *datarep;
    bool external;      /* the bytes of elements are in external32's order */
    MPI_Offset pointer; /* the rank's own, in etypes */
    bool atomic;
    struct file_server *server; /* of rank 0, if there are others */
    MPI_Offset shared;          /* of rank 0: the shared pointer, in etypes */
    MPI_Status split;           /* of the first of two calls, for the second */
};

struct file *file_of(MPI_File handle); /* NULL: none */
/* As fail. file NULL: by the handler for files that are not open. */
int fail_file(struct file *f, int call, int code, const char *fmt, ...) __attribute__((format(printf, 4, 5)));
int fail_no_file(int call);
/* What an error of the file system is for MPI. */
int file_error(int why);
/* All ranks meet, and agree on the worst of their codes. If there is none, rank 0 does `work` meanwhile; what
 * that returns is a code, too. */
typedef int file_work(struct file *f, MPI_Offset number);
int file_meet(struct file *f, int call, int code, file_work *work, MPI_Offset number);

/* --- the view --- */

/* A range of the view, as pieces of the file. */
struct view_walk {
    const struct file *f;
    const struct type *t;
    MPI_Offset tile; /* where the filetype is */
    int run;
    size_t skip, left; /* of the run; of the range */
};
struct view_walk view_walk(const struct file *f, MPI_Offset at, size_t bytes);
/* The next piece, as long as possible. False: there is none. */
bool view_next(struct view_walk *w, MPI_Offset *at, size_t *bytes);
/* How many etypes lie before the end of the file; a part of one counts. -1 with errno. */
MPI_Offset view_end(const struct file *f);
void view_first(struct file *f); /* all bytes of the file */
void view_leave(struct file *f);

/* --- representations of data --- */

const struct datarep *datarep_named(const char *name); /* NULL: none */
const char *datarep_name(const struct datarep *r);
int datarep_extent(const struct datarep *r, MPI_Datatype type, MPI_Aint *extent); /* in the file */

/* --- the server on rank 0 --- */

void server_begin(struct file *f); /* on all ranks */
void server_end(struct file *f);
/* Adds to the shared pointer. Returns what it was. */
MPI_Offset server_add(struct file *f, int call, MPI_Offset etypes);
/* Between these no other rank moves bytes in atomic mode. */
void server_lock(struct file *f, int call);
void server_unlock(struct file *f, int call);
#endif
