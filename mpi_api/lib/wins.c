/* wins.c - making and freeing windows, and what is known of them. */
#include "wins.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct win *win_of(MPI_Win handle)
{
    return object_of(handle, WIN);
}

int fail_win(struct win *w, int call, int code, const char *fmt, ...)
{
    va_list ap;
    va_start(ap, fmt);
    fail_by(w->handler, &(MPI_Win){HANDLE(MPI_Win, w)}, call, code, fmt, ap);
    va_end(ap);
    return code;
}

int fail_no_win(int call)
{
    return fail(NULL, call, MPI_ERR_WIN, "the window is null, or freed");
}

int win_check_idle(struct win *w, int call)
{
    const char *begun = w->started  ? "MPI_Win_start"
                        : w->posted ? "MPI_Win_post"
                        : w->all    ? "MPI_Win_lock_all"
                        : w->locks  ? "MPI_Win_lock"
                                    : NULL;
    return begun ? fail_win(w, call, MPI_ERR_RMA_SYNC, "an epoch of %s goes on", begun) : MPI_SUCCESS;
}

/* --- making and freeing --- */

static int check(struct comm *c, int call, MPI_Aint size, int unit)
{
    if (!c || c->remote)
        return fail_groups(c, call);
    if (size < 0)
        return fail(c, call, MPI_ERR_SIZE, "a window of %ld bytes", (long)size);
    return unit < 1 ? fail(c, call, MPI_ERR_DISP, "a unit of %d bytes", unit) : MPI_SUCCESS;
}

static void make(struct win *w, struct comm *c, int call, MPI_Info info, MPI_Win *win)
{
    const struct coll o = coll_of(c, call);
    const struct remote own = {w->size, w->unit};
    w->comm = comm_new(group_keep(c->local), NULL, comm_agree_context(&o));
    w->handler = MPI_ERRORS_ARE_FATAL, w->info = MPI_INFO_NULL;
    w->remote = get_memory((size_t)o.size * sizeof *w->remote);
    w->locked = get_memory((size_t)o.size * sizeof *w->locked);
    memset(w->locked, 0, (size_t)o.size * sizeof *w->locked);
    w->last_kept = &w->kept, w->last_pending = &w->pending;
    *win = HANDLE(MPI_Win, w);
    PMPI_Win_set_info(*win, info);
    passive_begin(w); /* before any rank can lock */
    coll_allgather_bytes(&o, &own, sizeof own, w->remote);
}

CALL(Win_create, (void *base, MPI_Aint size, int unit, MPI_Info info, MPI_Comm comm, MPI_Win *win))
{
    struct comm *c = comm_of(comm);
    int code = check(c, CALL_Win_create, size, unit);
    if (code)
        return code;
    struct win *w = object_new(WIN, sizeof *w);
    w->flavor = MPI_WIN_FLAVOR_CREATE, w->base = base, w->size = size, w->unit = unit;
    make(w, c, CALL_Win_create, info, win);
    return MPI_SUCCESS;
}

static int allocate(int call, int flavor, MPI_Aint size, int unit, MPI_Info info, struct comm *c, void *base,
                    MPI_Win *win)
{
    int code = check(c, call, size, unit);
    if (code)
        return code;
    struct win *w = object_new(WIN, sizeof *w);
    w->flavor = flavor, w->size = size, w->unit = unit, w->allocated = true;
    w->base = get_memory((size_t)size + !size);
    memcpy(base, &w->base, sizeof w->base);
    make(w, c, call, info, win);
    return MPI_SUCCESS;
}

CALL(Win_allocate, (MPI_Aint size, int unit, MPI_Info info, MPI_Comm comm, void *base, MPI_Win *win))
{
    return allocate(CALL_Win_allocate, MPI_WIN_FLAVOR_ALLOCATE, size, unit, info, comm_of(comm), base, win);
}

/* No two nodes share memory: the communicator, as MPI_Comm_split_type makes it, has one rank. */
CALL(Win_allocate_shared, (MPI_Aint size, int unit, MPI_Info info, MPI_Comm comm, void *base, MPI_Win *win))
{
    struct comm *c = comm_of(comm);
    if (c && c->local->size > 1)
        return fail(c, CALL_Win_allocate_shared, MPI_ERR_RMA_SHARED,
                    "nodes share no memory: MPI_Comm_split_type tells which ranks do");
    return allocate(CALL_Win_allocate_shared, MPI_WIN_FLAVOR_SHARED, size, unit, info, c, base, win);
}

CALL(Win_shared_query, (MPI_Win win, int rank, MPI_Aint *size, int *unit, void *base))
{
    struct win *w = win_of(win);
    if (!w)
        return fail_no_win(CALL_Win_shared_query);
    if (w->flavor != MPI_WIN_FLAVOR_SHARED)
        return fail_win(w, CALL_Win_shared_query, MPI_ERR_RMA_FLAVOR, "the window is not shared");
    (void)rank;
    *size = w->size, *unit = w->unit;
    memcpy(base, &w->base, sizeof w->base);
    return MPI_SUCCESS;
}

/* All memory of the rank; places are addresses. */
CALL(Win_create_dynamic, (MPI_Info info, MPI_Comm comm, MPI_Win *win))
{
    struct comm *c = comm_of(comm);
    int code = check(c, CALL_Win_create_dynamic, 0, 1);
    if (code)
        return code;
    struct win *w = object_new(WIN, sizeof *w);
    w->flavor = MPI_WIN_FLAVOR_DYNAMIC, w->unit = 1;
    make(w, c, CALL_Win_create_dynamic, info, win);
    return MPI_SUCCESS;
}

static int check_dynamic(int call, MPI_Win win)
{
    struct win *w = win_of(win);
    if (!w)
        return fail_no_win(call);
    return w->flavor == MPI_WIN_FLAVOR_DYNAMIC
               ? MPI_SUCCESS
               : fail_win(w, call, MPI_ERR_RMA_FLAVOR, "the window is not a dynamic one");
}

CALL(Win_attach, (MPI_Win win, void *base, MPI_Aint size))
{
    (void)base, (void)size;
    return check_dynamic(CALL_Win_attach, win);
}

CALL(Win_detach, (MPI_Win win, const void *base))
{
    (void)base;
    return check_dynamic(CALL_Win_detach, win);
}

CALL(Win_free, (MPI_Win * win))
{
    struct win *w = win_of(*win);
    if (!w)
        return fail_no_win(CALL_Win_free);
    int code = win_check_idle(w, CALL_Win_free);
    if (code)
        return code;
    const struct coll o = coll_of(w->comm, CALL_Win_free);
    code = attribute_delete_all((void *)*win, &w->attributes);
    if (code)
        return fail_win(w, CALL_Win_free, code, "an attribute's delete function says no");
    coll_barrier(&o);
    passive_end(w);
    info_keep(&w->info, MPI_INFO_NULL);
    if (w->allocated)
        free(w->base);
    comm_leave(w->comm);
    PMPI_Errhandler_free(&w->handler);
    object_leave(&w->object);
    free(w->remote);
    free(w->locked);
    free(w->name);
    free(w);
    *win = MPI_WIN_NULL;
    return MPI_SUCCESS;
}

/* --- what is known --- */

CALL(Win_get_group, (MPI_Win win, MPI_Group *group))
{
    struct win *w = win_of(win);
    return w ? PMPI_Comm_group(HANDLE(MPI_Comm, w->comm), group) : fail_no_win(CALL_Win_get_group);
}

CALL(Win_set_name, (MPI_Win win, const char *name))
{
    struct win *w = win_of(win);
    if (!w)
        return fail_no_win(CALL_Win_set_name);
    free(w->name);
    w->name = strndup(name, MPI_MAX_OBJECT_NAME - 1);
    return MPI_SUCCESS;
}

CALL(Win_get_name, (MPI_Win win, char *name, int *length))
{
    const struct win *w = win_of(win);
    if (!w && win != MPI_WIN_NULL)
        return fail_no_win(CALL_Win_get_name);
    *length = snprintf(name, MPI_MAX_OBJECT_NAME, "%s", !w ? "MPI_WIN_NULL" : w->name ? w->name : "");
    return MPI_SUCCESS;
}

CALL(Win_set_info, (MPI_Win win, MPI_Info info))
{
    struct win *w = win_of(win);
    if (!w)
        return fail_no_win(CALL_Win_set_info);
    return info_keep(&w->info, info);
}

CALL(Win_get_info, (MPI_Win win, MPI_Info *info))
{
    const struct win *w = win_of(win);
    if (!w)
        return fail_no_win(CALL_Win_get_info);
    return info_give(w->info, info);
}

/* --- attributes --- */

CALL(Win_create_keyval,
     (MPI_Win_copy_attr_function * copy, MPI_Win_delete_attr_function *delete, int *keyval, void *extra))
{
    return attribute_key((void *)copy, (void *)delete, keyval, extra, false);
}

CALL(Win_free_keyval, (int *keyval))
{
    return attribute_key_free(CALL_Win_free_keyval, keyval);
}

static int told(struct win *w, int call, int code)
{
    return code ? fail_win(w, call, code, "%s", attribute_why(code)) : MPI_SUCCESS;
}

CALL(Win_set_attr, (MPI_Win win, int keyval, void *value))
{
    struct win *w = win_of(win);
    if (!w)
        return fail_no_win(CALL_Win_set_attr);
    return told(w, CALL_Win_set_attr, attribute_set(win, &w->attributes, keyval, value));
}

CALL(Win_delete_attr, (MPI_Win win, int keyval))
{
    struct win *w = win_of(win);
    if (!w)
        return fail_no_win(CALL_Win_delete_attr);
    return told(w, CALL_Win_delete_attr, attribute_delete(win, &w->attributes, keyval));
}

/* The base is the pointer itself, the others are pointers to numbers. */
CALL(Win_get_attr, (MPI_Win win, int keyval, void *value, int *flag))
{
    static int model = MPI_WIN_UNIFIED;
    struct win *w = win_of(win);
    if (!w)
        return fail_no_win(CALL_Win_get_attr);
    const void *own = keyval == MPI_WIN_BASE            ? w->base
                      : keyval == MPI_WIN_SIZE          ? (void *)&w->size
                      : keyval == MPI_WIN_DISP_UNIT     ? (void *)&w->unit
                      : keyval == MPI_WIN_CREATE_FLAVOR ? (void *)&w->flavor
                                                        : &model;
    if (keyval < MPI_WIN_BASE || keyval > MPI_WIN_MODEL)
        return told(w, CALL_Win_get_attr, attribute_get(&w->attributes, keyval, value, flag));
    memcpy(value, &own, sizeof own);
    *flag = true;
    return MPI_SUCCESS;
}

/* --- error handlers --- */

CALL(Win_create_errhandler, (MPI_Win_errhandler_function * function, MPI_Errhandler *handler))
{
    return PMPI_Comm_create_errhandler((MPI_Comm_errhandler_function *)(void *)function, handler);
}

CALL(Win_set_errhandler, (MPI_Win win, MPI_Errhandler handler))
{
    struct win *w = win_of(win);
    if (!w)
        return fail_no_win(CALL_Win_set_errhandler);
    return handler_set(CALL_Win_set_errhandler, &w->handler, handler);
}

CALL(Win_get_errhandler, (MPI_Win win, MPI_Errhandler *handler))
{
    const struct win *w = win_of(win);
    if (!w)
        return fail_no_win(CALL_Win_get_errhandler);
    *handler = handler_get(w->handler);
    return MPI_SUCCESS;
}

CALL(Win_call_errhandler, (MPI_Win win, int code))
{
    const struct win *w = win_of(win);
    return w ? handler_call(CALL_Win_call_errhandler, w->handler, &win, code)
             : fail_no_win(CALL_Win_call_errhandler);
}
