/* told.h - MPI's calls as the program makes them, for those who check or record them: an observer hears
 * library_begins and library_ends (os/observer.h). Here are the arguments of a call by their names in
 * mpi_calls.h, and the objects that they name; told_accesses.h has the memory that a call reads or writes.
 *
 * All that belongs to the node is read where the program has it: only when the node is known to stand still,
 * as in a call. Wrong arguments have no objects: the library tells of them. */
#ifndef MPI_TOLD_H
#define MPI_TOLD_H
#include "mpi_api/core/library.h"

struct node;

/* The call's name, in a text that lasts. */
const char *told_name(const struct nxm_told *c);
/* An argument by its name, such as "tag"; false: the call has none of that name. */
bool told_argument(const struct nxm_told *c, const char *name, uintptr_t *value);
/* An int of that name; `none` if there is none. */
int told_int(const struct nxm_told *c, const char *name, int none);
/* Where the call gives back a handle of a type, such as "MPI_Comm"; NULL: nowhere. */
uintptr_t *told_pointer(const struct nxm_told *c, const char *type);
/* What the call is without its form: "Send" of MPI_Isend, "Bcast" of MPI_Ibcast and MPI_Bcast_init. */
const char *told_stem(const struct nxm_told *c);

/* The datatype behind a handle: one of MPI's own, or made of others; NULL: it is none of these. */
const struct basic *told_basic(const struct nxm_library *l, uintptr_t type);
const struct type *told_type(const struct nxm_library *l, uintptr_t type);
/* The object behind a handle; NULL: none of that kind. */
struct object *told_object(const struct nxm_library *l, uintptr_t handle, enum kind kind);
/* The communicator of the call; NULL: it has none. */
const struct comm *told_comm(const struct nxm_library *l, const struct nxm_told *c);
#endif
