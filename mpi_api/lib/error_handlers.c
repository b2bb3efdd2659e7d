/* error_handlers.c - error handlers, codes and their texts. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lib.h"

struct errhandler {
    struct object object;
    MPI_Comm_errhandler_function *function;
};

static const char *const texts[] = {
    [MPI_SUCCESS] = "no error",
    [MPI_ERR_BUFFER] = "invalid buffer",
    [MPI_ERR_COUNT] = "invalid count",
    [MPI_ERR_TYPE] = "invalid datatype",
    [MPI_ERR_TAG] = "invalid tag",
    [MPI_ERR_COMM] = "invalid communicator",
    [MPI_ERR_RANK] = "invalid rank",
    [MPI_ERR_REQUEST] = "invalid request",
    [MPI_ERR_ROOT] = "invalid root",
    [MPI_ERR_GROUP] = "invalid group",
    [MPI_ERR_OP] = "invalid operation",
    [MPI_ERR_TOPOLOGY] = "invalid topology",
    [MPI_ERR_DIMS] = "invalid dimensions",
    [MPI_ERR_ARG] = "invalid argument",
    [MPI_ERR_UNKNOWN] = "unknown error",
    [MPI_ERR_TRUNCATE] = "the message is longer than the receive",
    [MPI_ERR_OTHER] = "another error",
    [MPI_ERR_INTERN] = "an error of the library",
    [MPI_ERR_PENDING] = "the request is not done",
    [MPI_ERR_IN_STATUS] = "the error is in the statuses",
    [MPI_ERR_ACCESS] = "the file may not be used like this",
    [MPI_ERR_AMODE] = "invalid mode of opening a file",
    [MPI_ERR_ASSERT] = "invalid assertion",
    [MPI_ERR_BAD_FILE] = "invalid name of a file",
    [MPI_ERR_BASE] = "invalid address",
    [MPI_ERR_CONVERSION] = "data cannot be converted",
    [MPI_ERR_DUP_DATAREP] = "there is such a representation of data",
    [MPI_ERR_FILE_EXISTS] = "the file exists",
    [MPI_ERR_FILE_IN_USE] = "the file is in use",
    [MPI_ERR_FILE] = "invalid file",
    [MPI_ERR_INFO_KEY] = "invalid key of an info",
    [MPI_ERR_INFO_NOKEY] = "the info has no such key",
    [MPI_ERR_INFO_VALUE] = "invalid value of an info",
    [MPI_ERR_INFO] = "invalid info",
    [MPI_ERR_IO] = "an error of the file system",
    [MPI_ERR_KEYVAL] = "invalid attribute key",
    [MPI_ERR_NAME] = "no such name of a service",
    [MPI_ERR_NO_MEM] = "no memory left",
    [MPI_ERR_NOT_SAME] = "an argument differs between ranks",
    [MPI_ERR_NO_SPACE] = "no space left",
    [MPI_ERR_NO_SUCH_FILE] = "no such file",
    [MPI_ERR_PORT] = "invalid name of a port",
    [MPI_ERR_QUOTA] = "the quota is used up",
    [MPI_ERR_READ_ONLY] = "the file is for reading only",
    [MPI_ERR_DISP] = "invalid unit of displacements",
    [MPI_ERR_LOCKTYPE] = "invalid kind of lock",
    [MPI_ERR_RMA_RANGE] = "outside of the window",
    [MPI_ERR_RMA_ATTACH] = "the memory cannot be attached",
    [MPI_ERR_RMA_CONFLICT] = "accesses to the window are in conflict",
    [MPI_ERR_RMA_SHARED] = "the memory cannot be shared",
    [MPI_ERR_RMA_SYNC] = "the window may not be used at this time",
    [MPI_ERR_RMA_FLAVOR] = "not for windows of this kind",
    [MPI_ERR_SERVICE] = "invalid name of a service",
    [MPI_ERR_SPAWN] = "processes cannot be spawned",
    [MPI_ERR_SIZE] = "invalid size",
    [MPI_ERR_WIN] = "invalid window",
    [MPI_ERR_UNSUPPORTED_DATAREP] = "no such representation of data",
    [MPI_ERR_UNSUPPORTED_OPERATION] = "not supported",
};

/* --- errors of calls --- */

static void call_handler(MPI_Errhandler handler, void *handle, int call, int code, const char *text)
{
    struct errhandler *own = object_of(handler, ERRHANDLER);
    if (own)
        own->function(handle, &code);
    else if (handler != MPI_ERRORS_RETURN)
        nxm_fail(call, text);
}

int fail_by(MPI_Errhandler handler, void *handle, int call, int code, const char *fmt, va_list ap)
{
    char text[200];
    vsnprintf(text, sizeof text, fmt, ap);
    call_handler(handler, handle, call, code, text);
    return code;
}

static MPI_Comm handle_of(const struct comm *c)
{
    return c == &comm_world ? MPI_COMM_WORLD : c == &comm_self ? MPI_COMM_SELF : HANDLE(MPI_Comm, c);
}

int fail(struct comm *c, int call, int code, const char *fmt, ...)
{
    va_list ap;
    va_start(ap, fmt);
    c = c ? c : &comm_world;
    fail_by(c->handler, &(MPI_Comm){handle_of(c)}, call, code, fmt, ap);
    va_end(ap);
    return code;
}

int fail_comm(int call)
{
    return fail(NULL, call, MPI_ERR_COMM, "%s",
                mpi_runs ? "the communicator is null, or freed"
                         : "called before MPI_Init, or after MPI_Finalize");
}

int fail_groups(struct comm *c, int call)
{
    return c ? fail(c, call, MPI_ERR_COMM, "not for communicators of two groups") : fail_comm(call);
}

int fail_answer(struct comm *c, int call)
{
    return fail(c, call, MPI_ERR_ARG, "the pointer to where the answer goes is null");
}

/* --- handlers --- */

CALL(Comm_create_errhandler, (MPI_Comm_errhandler_function * function, MPI_Errhandler *handler))
{
    struct errhandler *h = object_new(ERRHANDLER, sizeof *h);
    h->function = function;
    *handler = HANDLE(MPI_Errhandler, h);
    return MPI_SUCCESS;
}

int handler_set(int call, MPI_Errhandler *of, MPI_Errhandler handler)
{
    struct errhandler *h = object_of(handler, ERRHANDLER);
    if (!h && handler != MPI_ERRORS_ARE_FATAL && handler != MPI_ERRORS_RETURN && handler != MPI_ERRORS_ABORT)
        return fail(NULL, call, MPI_ERR_ARG, "the error handler is null, or has been freed");
    if (h)
        h->object.users++;
    PMPI_Errhandler_free(of);
    *of = handler;
    return MPI_SUCCESS;
}

MPI_Errhandler handler_get(MPI_Errhandler handler)
{
    struct errhandler *h = object_of(handler, ERRHANDLER);
    if (h)
        h->object.users++;
    return handler;
}

int handler_call(int call, MPI_Errhandler handler, void *handle, int code)
{
    char text[MPI_MAX_ERROR_STRING];
    int length;
    PMPI_Error_string(code, text, &length);
    call_handler(handler, handle, call, code, text);
    return MPI_SUCCESS;
}

CALL(Comm_set_errhandler, (MPI_Comm comm, MPI_Errhandler handler))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Comm_set_errhandler);
    return handler_set(CALL_Comm_set_errhandler, &c->handler, handler);
}

CALL(Comm_get_errhandler, (MPI_Comm comm, MPI_Errhandler *handler))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Comm_get_errhandler);
    *handler = handler_get(c->handler);
    return MPI_SUCCESS;
}

CALL(Comm_call_errhandler, (MPI_Comm comm, int code))
{
    struct comm *c = comm_of(comm);
    return c ? handler_call(CALL_Comm_call_errhandler, c->handler, &comm, code)
             : fail_comm(CALL_Comm_call_errhandler);
}

CALL(Errhandler_free, (MPI_Errhandler * handler))
{
    struct errhandler *h = object_of(*handler, ERRHANDLER);
    if (h && object_leave(&h->object))
        free(h);
    *handler = MPI_ERRHANDLER_NULL;
    return MPI_SUCCESS;
}

/* --- codes: those that programs add are behind MPI_ERR_LASTCODE --- */

enum { FIRST_ADDED = MPI_ERR_LASTCODE + 1 };
static struct added {
    int class;
    char *text;
} * added;
static int added_count;

static int add(int class)
{
    added = realloc(added, (size_t)(added_count + 1) * sizeof *added);
    added[added_count] = (struct added){class, NULL};
    return FIRST_ADDED + added_count++;
}

static struct added *added_of(int code)
{
    return code >= FIRST_ADDED && code < FIRST_ADDED + added_count ? &added[code - FIRST_ADDED] : NULL;
}

int error_last_code(void)
{
    return added_count ? FIRST_ADDED + added_count - 1 : MPI_ERR_LASTCODE;
}

CALL(Add_error_class, (int *class))
{
    *class = add(0);
    added_of(*class)->class = *class;
    return MPI_SUCCESS;
}

CALL(Add_error_code, (int class, int *code))
{
    *code = add(class);
    return MPI_SUCCESS;
}

CALL(Add_error_string, (int code, const char *text))
{
    struct added *a = added_of(code);
    if (!a)
        return fail(NULL, CALL_Add_error_string, MPI_ERR_ARG,
                    "%d is no error code that the program has added", code);
    free(a->text);
    a->text = strndup(text, MPI_MAX_ERROR_STRING - 1);
    return MPI_SUCCESS;
}

CALL(Error_string, (int code, char *text, int *length))
{
    const struct added *a = added_of(code);
    bool known = code >= 0 && code < (int)(sizeof texts / sizeof *texts) && texts[code];
    *length = snprintf(text, MPI_MAX_ERROR_STRING, "%s",
                       a       ? (a->text ? a->text : "")
                       : known ? texts[code]
                               : "unknown error code");
    return MPI_SUCCESS;
}

CALL(Error_class, (int code, int *class))
{
    const struct added *a = added_of(code);
    *class = a ? a->class : code;
    return MPI_SUCCESS;
}
