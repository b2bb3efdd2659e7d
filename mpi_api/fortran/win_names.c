/* win_names.c - Fortran's names for the calls on windows. Places and sizes are INTEGERs of
 * MPI_ADDRESS_KIND. */
#include "keyvals.h"
#include "mpi_api/lib/wins.h"

#define F_WIN(x) F_HANDLE(MPI_Win, *(x))
#define F_INFO(x) F_HANDLE(MPI_Info, *(x))

FORTRAN(win_create,
        (void *base, MPI_Aint *size, f_int *unit, f_int *info, f_int *comm, f_int *win, f_int *ierr))
{
    WITH(MPI_Win, win, MPI_Win_create(base, *size, *unit, F_INFO(info), F_COMM(comm), &handle));
}

/* base: an INTEGER of MPI_ADDRESS_KIND, or a C_PTR, which is as long. */
FORTRAN(win_allocate,
        (MPI_Aint * size, f_int *unit, f_int *info, f_int *comm, void *base, f_int *win, f_int *ierr))
{
    WITH(MPI_Win, win, MPI_Win_allocate(*size, *unit, F_INFO(info), F_COMM(comm), base, &handle));
}

FORTRAN(win_allocate_shared,
        (MPI_Aint * size, f_int *unit, f_int *info, f_int *comm, void *base, f_int *win, f_int *ierr))
{
    NEW(MPI_Win, win, MPI_Win_allocate_shared(*size, *unit, F_INFO(info), F_COMM(comm), base, &made));
}

FORTRAN(win_shared_query, (f_int * win, f_int *rank, MPI_Aint *size, f_int *unit, void *base, f_int *ierr))
{
    IERR = MPI_Win_shared_query(F_WIN(win), *rank, size, unit, base);
}

/* Places in a dynamic window are Fortran's addresses, which are counted from MPI_BOTTOM. */
FORTRAN(win_create_dynamic, (f_int * info, f_int *comm, f_int *win, f_int *ierr))
{
    WITH(MPI_Win, win, MPI_Win_create_dynamic(F_INFO(info), F_COMM(comm), &handle));
    if (!IERR)
        win_of(F_WIN(win))->base = (char *)&mpi_fortran_bottom_;
}

FORTRAN(win_attach, (f_int * win, void *base, MPI_Aint *size, f_int *ierr))
{
    IERR = MPI_Win_attach(F_WIN(win), base, *size);
}

FORTRAN(win_detach, (f_int * win, void *base, f_int *ierr))
{
    IERR = MPI_Win_detach(F_WIN(win), base);
}

FORTRAN(win_free, (f_int * win, f_int *ierr))
{
    WITH(MPI_Win, win, MPI_Win_free(&handle));
}

FORTRAN(win_get_group, (f_int * win, f_int *group, f_int *ierr))
{
    WITH(MPI_Group, group, MPI_Win_get_group(F_WIN(win), &handle));
}

/* The base is an address; the others are numbers. */
FORTRAN(win_get_attr, (f_int * win, f_int *key, MPI_Aint *value, f_int *flag, f_int *ierr))
{
    void *found;
    IERR = MPI_Win_get_attr(F_WIN(win), *key, &found, flag);
    if (IERR || !*flag)
        return;
    *value = *key == MPI_WIN_SIZE ? *(MPI_Aint *)found
             : *key > MPI_WIN_BASE && *key <= MPI_WIN_MODEL
                 ? *(int *)found
                 : attribute_number(win_of(F_WIN(win))->attributes, found);
}

FORTRAN(win_set_attr, (f_int * win, f_int *key, MPI_Aint *value, f_int *ierr))
{
    IERR = MPI_Win_set_attr(F_WIN(win), *key, (void *)*value);
    if (!IERR)
        attribute_last_is_number(win_of(F_WIN(win))->attributes);
}

KEYS(win, Win, MPI_Win)

NAMES(win, Win, F_WIN)

FORTRAN(win_set_info, (f_int * win, f_int *info, f_int *ierr))
{
    IERR = MPI_Win_set_info(F_WIN(win), F_HANDLE(MPI_Info, *info));
}

FORTRAN(win_get_info, (f_int * win, f_int *info, f_int *ierr))
{
    NEW(MPI_Info, info, MPI_Win_get_info(F_WIN(win), &made));
}

FORTRAN(win_create_errhandler, (MPI_Win_errhandler_function * function, f_int *handler, f_int *ierr))
{
    WITH(MPI_Errhandler, handler, MPI_Win_create_errhandler(function, &handle));
}

FORTRAN(win_set_errhandler, (f_int * win, f_int *handler, f_int *ierr))
{
    IERR = MPI_Win_set_errhandler(F_WIN(win), F_HANDLE(MPI_Errhandler, *handler));
}

FORTRAN(win_get_errhandler, (f_int * win, f_int *handler, f_int *ierr))
{
    WITH(MPI_Errhandler, handler, MPI_Win_get_errhandler(F_WIN(win), &handle));
}

FORTRAN(win_call_errhandler, (f_int * win, f_int *code, f_int *ierr))
{
    IERR = MPI_Win_call_errhandler(F_WIN(win), *code);
}

/* --- epochs --- */

FORTRAN(win_fence, (f_int * assert, f_int *win, f_int *ierr))
{
    IERR = MPI_Win_fence(*assert, F_WIN(win));
}

FORTRAN(win_start, (f_int * group, f_int *assert, f_int *win, f_int *ierr))
{
    IERR = MPI_Win_start(F_HANDLE(MPI_Group, *group), *assert, F_WIN(win));
}

FORTRAN(win_post, (f_int * group, f_int *assert, f_int *win, f_int *ierr))
{
    IERR = MPI_Win_post(F_HANDLE(MPI_Group, *group), *assert, F_WIN(win));
}

FORTRAN(win_test, (f_int * win, f_int *flag, f_int *ierr))
{
    IERR = MPI_Win_test(F_WIN(win), flag);
}

FORTRAN(win_lock, (f_int * kind, f_int *rank, f_int *assert, f_int *win, f_int *ierr))
{
    IERR = MPI_Win_lock(*kind, *rank, *assert, F_WIN(win));
}

FORTRAN(win_lock_all, (f_int * assert, f_int *win, f_int *ierr))
{
    IERR = MPI_Win_lock_all(*assert, F_WIN(win));
}

#define OF_WIN(name, c_name)                                                                                 \
    FORTRAN(name, (f_int * win, f_int * ierr))                                                               \
    {                                                                                                        \
        IERR = MPI_##c_name(F_WIN(win));                                                                     \
    }
#define OF_RANK(name, c_name)                                                                                \
    FORTRAN(name, (f_int * rank, f_int * win, f_int * ierr))                                                 \
    {                                                                                                        \
        IERR = MPI_##c_name(*rank, F_WIN(win));                                                              \
    }
OF_WIN(win_complete, Win_complete)
OF_WIN(win_wait, Win_wait)
OF_WIN(win_unlock_all, Win_unlock_all)
OF_WIN(win_flush_all, Win_flush_all)
OF_WIN(win_flush_local_all, Win_flush_local_all)
OF_WIN(win_sync, Win_sync)
OF_RANK(win_unlock, Win_unlock)
OF_RANK(win_flush, Win_flush)
OF_RANK(win_flush_local, Win_flush_local)

/* --- accesses --- */

#define F_OP(x) F_HANDLE(MPI_Op, *(x))
#define THERE f_int *rank, MPI_Aint *place, f_int *their_count, f_int *their_type
#define GIVE_THERE *rank, *place, *their_count, F_TYPE(their_type)

FORTRAN(put, (void *buf, f_int *count, f_int *type, THERE, f_int *win, f_int *ierr))
{
    IERR = MPI_Put(buf, *count, F_TYPE(type), GIVE_THERE, F_WIN(win));
}

FORTRAN(get, (void *into, f_int *room, f_int *as, THERE, f_int *win, f_int *ierr))
{
    IERR = MPI_Get(into, *room, F_TYPE(as), GIVE_THERE, F_WIN(win));
}

FORTRAN(accumulate, (void *buf, f_int *count, f_int *type, THERE, f_int *op, f_int *win, f_int *ierr))
{
    IERR = MPI_Accumulate(buf, *count, F_TYPE(type), GIVE_THERE, F_OP(op), F_WIN(win));
}

FORTRAN(get_accumulate, (void *buf, f_int *count, f_int *type, void *into, f_int *room, f_int *as, THERE,
                         f_int *op, f_int *win, f_int *ierr))
{
    IERR = MPI_Get_accumulate(buf, *count, F_TYPE(type), into, *room, F_TYPE(as), GIVE_THERE, F_OP(op),
                              F_WIN(win));
}

FORTRAN(rput, (void *buf, f_int *count, f_int *type, THERE, f_int *win, f_int *request, f_int *ierr))
{
    NEW(MPI_Request, request, MPI_Rput(buf, *count, F_TYPE(type), GIVE_THERE, F_WIN(win), &made));
}

FORTRAN(rget, (void *into, f_int *room, f_int *as, THERE, f_int *win, f_int *request, f_int *ierr))
{
    NEW(MPI_Request, request, MPI_Rget(into, *room, F_TYPE(as), GIVE_THERE, F_WIN(win), &made));
}

FORTRAN(raccumulate,
        (void *buf, f_int *count, f_int *type, THERE, f_int *op, f_int *win, f_int *request, f_int *ierr))
{
    NEW(MPI_Request, request,
        MPI_Raccumulate(buf, *count, F_TYPE(type), GIVE_THERE, F_OP(op), F_WIN(win), &made));
}

FORTRAN(rget_accumulate, (void *buf, f_int *count, f_int *type, void *into, f_int *room, f_int *as, THERE,
                          f_int *op, f_int *win, f_int *request, f_int *ierr))
{
    NEW(MPI_Request, request,
        MPI_Rget_accumulate(buf, *count, F_TYPE(type), into, *room, F_TYPE(as), GIVE_THERE, F_OP(op),
                            F_WIN(win), &made));
}

FORTRAN(fetch_and_op, (void *buf, void *into, f_int *type, f_int *rank, MPI_Aint *place, f_int *op,
                       f_int *win, f_int *ierr))
{
    IERR = MPI_Fetch_and_op(buf, into, F_TYPE(type), *rank, *place, F_OP(op), F_WIN(win));
}

FORTRAN(compare_and_swap, (void *buf, void *compare, void *into, f_int *type, f_int *rank, MPI_Aint *place,
                           f_int *win, f_int *ierr))
{
    IERR = MPI_Compare_and_swap(buf, compare, into, F_TYPE(type), *rank, *place, F_WIN(win));
}
