/* files.c - opening and closing files, and what is known of them. */
#define _GNU_SOURCE
#include "files.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* --- errors --- */

static MPI_Errhandler default_handler = MPI_ERRORS_RETURN;

struct file *file_of(MPI_File handle)
{
    return object_of(handle, FILE_OBJECT);
}

int fail_file(struct file *f, int call, int code, const char *fmt, ...)
{
    va_list ap;
    va_start(ap, fmt);
    MPI_File handle = f ? HANDLE(MPI_File, f) : MPI_FILE_NULL;
    fail_by(f ? f->handler : default_handler, &handle, call, code, fmt, ap);
    va_end(ap);
    return code;
}

int fail_no_file(int call)
{
    return fail_file(NULL, call, MPI_ERR_FILE, "the file is null, or closed");
}

int file_error(int why)
{
    static const struct pair {
        int why, code;
    } pairs[] = {{ENOENT, MPI_ERR_NO_SUCH_FILE}, {EEXIST, MPI_ERR_FILE_EXISTS},    {EACCES, MPI_ERR_ACCESS},
                 {EPERM, MPI_ERR_ACCESS},        {EROFS, MPI_ERR_READ_ONLY},       {ENOSPC, MPI_ERR_NO_SPACE},
                 {EDQUOT, MPI_ERR_QUOTA},        {ENAMETOOLONG, MPI_ERR_BAD_FILE}, {EISDIR, MPI_ERR_BAD_FILE},
                 {ENOTDIR, MPI_ERR_BAD_FILE}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        if (pairs[i].why == why)
            return pairs[i].code;
    return MPI_ERR_IO;
}

int file_meet(struct file *f, int call, int code, file_work *work, MPI_Offset number)
{
    const struct coll o = coll_of(f->comm, call);
    int worst = code;
    coll_reduce(&o, &code, &worst, 1, MPI_INT, MPI_MAX, 0);
    if (!o.rank && !worst && work)
        worst = work(f, number);
    coll_bcast(&o, &worst, 1, MPI_INT, 0);
    return worst;
}

/* --- opening and closing --- */

static int check_amode(int amode)
{
    int access = amode & (MPI_MODE_RDONLY | MPI_MODE_WRONLY | MPI_MODE_RDWR);
    if (access != MPI_MODE_RDONLY && access != MPI_MODE_WRONLY && access != MPI_MODE_RDWR)
        return MPI_ERR_AMODE;
    if (access == MPI_MODE_RDONLY && amode & (MPI_MODE_CREATE | MPI_MODE_EXCL))
        return MPI_ERR_AMODE;
    return access == MPI_MODE_RDWR && amode & MPI_MODE_SEQUENTIAL ? MPI_ERR_AMODE : MPI_SUCCESS;
}

/* ROMIO's names say the file system before a colon: "pfs:/pfs/data". */
static const char *plain_name(const char *name)
{
    size_t letters = strspn(name, "abcdefghijklmnopqrstuvwxyz");
    return letters > 1 && name[letters] == ':' ? name + letters + 1 : name;
}

/* The file's end is where it is before the ranks meet: behind that, one may have written. */
static int open_own(struct file *f, int flags)
{
    flags |= f->amode & MPI_MODE_RDONLY ? O_RDONLY : f->amode & MPI_MODE_WRONLY ? O_WRONLY : O_RDWR;
    f->fd = open(f->name, flags, 0666);
    if (f->fd >= 0 && f->amode & MPI_MODE_APPEND)
        f->pointer = f->shared = lseek(f->fd, 0, SEEK_END);
    return f->fd < 0 ? file_error(errno) : MPI_SUCCESS;
}

static int create(struct file *f, MPI_Offset unused)
{
    (void)unused;
    return open_own(f, (f->amode & MPI_MODE_CREATE ? O_CREAT : 0) | (f->amode & MPI_MODE_EXCL ? O_EXCL : 0));
}

/* Rank 0 creates the file, so that the others find it. */
static int open_together(struct file *f)
{
    const struct coll o = coll_of(f->comm, CALL_File_open);
    int amode = f->amode, code = check_amode(amode);
    coll_bcast(&o, &amode, 1, MPI_INT, 0);
    code = code || amode == f->amode ? code : MPI_ERR_NOT_SAME;
    code = file_meet(f, CALL_File_open, code, create, 0);
    if (o.size == 1 || code)
        return code;
    return file_meet(f, CALL_File_open, o.rank ? open_own(f, 0) : MPI_SUCCESS, NULL, 0);
}

static void file_free(struct file *f)
{
    if (f->fd >= 0)
        close(f->fd);
    view_leave(f);
    info_keep(&f->info, MPI_INFO_NULL);
    comm_leave(f->comm);
    PMPI_Errhandler_free(&f->handler);
    object_leave(&f->object);
    free(f->name);
    free(f);
}

CALL(File_open, (MPI_Comm comm, const char *name, int amode, MPI_Info info, MPI_File *file))
{
    struct comm *c = comm_of(comm);
    if (!c || c->remote)
        return fail_groups(c, CALL_File_open);
    const struct coll o = coll_of(c, CALL_File_open);
    struct file *f = object_new(FILE_OBJECT, sizeof *f);
    *file = MPI_FILE_NULL;
    f->comm = comm_new(group_keep(c->local), NULL, comm_agree_context(&o));
    f->fd = -1, f->amode = amode, f->name = strdup(plain_name(name));
    f->info = MPI_INFO_NULL;
    f->handler = handler_get(default_handler);
    view_first(f);
    int code = open_together(f);
    if (code) {
        fail_file(NULL, CALL_File_open, code, "%s cannot be opened, on this rank or another", f->name);
        return file_free(f), code;
    }
    *file = HANDLE(MPI_File, f);
    server_begin(f);
    return info == MPI_INFO_NULL ? MPI_SUCCESS : PMPI_File_set_info(*file, info);
}

static int remove_file(struct file *f, MPI_Offset unused)
{
    (void)unused;
    return unlink(f->name) ? file_error(errno) : MPI_SUCCESS;
}

CALL(File_close, (MPI_File * file))
{
    struct file *f = file_of(*file);
    if (!f)
        return fail_no_file(CALL_File_close);
    bool removes = f->amode & MPI_MODE_DELETE_ON_CLOSE;
    int code = close(f->fd) ? file_error(errno) : MPI_SUCCESS;
    f->fd = -1;
    code = file_meet(f, CALL_File_close, code, removes ? remove_file : NULL, 0);
    if (code)
        fail_file(f, CALL_File_close, code, "%s cannot be closed, or deleted", f->name);
    server_end(f);
    file_free(f);
    *file = MPI_FILE_NULL;
    return code;
}

CALL(File_delete, (const char *name, MPI_Info info))
{
    (void)info;
    if (!unlink(plain_name(name)))
        return MPI_SUCCESS;
    return fail_file(NULL, CALL_File_delete, file_error(errno), "%s cannot be deleted", name);
}

/* --- sizes --- */

static int set_size(struct file *f, MPI_Offset bytes)
{
    return ftruncate64(f->fd, bytes) ? file_error(errno) : MPI_SUCCESS;
}

static int grow(struct file *f, MPI_Offset bytes)
{
    off_t size = lseek(f->fd, 0, SEEK_END);
    return size < 0 ? file_error(errno) : size < bytes ? set_size(f, bytes) : MPI_SUCCESS;
}

static int resize(MPI_File file, int call, MPI_Offset bytes, file_work *work)
{
    struct file *f = file_of(file);
    if (!f)
        return fail_no_file(call);
    int code = bytes < 0 ? MPI_ERR_ARG : f->amode & MPI_MODE_RDONLY ? MPI_ERR_READ_ONLY : MPI_SUCCESS;
    code = file_meet(f, call, code, work, bytes);
    return code ? fail_file(f, call, code, "%s cannot have %ld bytes", f->name, (long)bytes) : MPI_SUCCESS;
}

CALL(File_set_size, (MPI_File file, MPI_Offset bytes))
{
    return resize(file, CALL_File_set_size, bytes, set_size);
}

CALL(File_preallocate, (MPI_File file, MPI_Offset bytes))
{
    return resize(file, CALL_File_preallocate, bytes, grow);
}

CALL(File_get_size, (MPI_File file, MPI_Offset *bytes))
{
    struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_get_size);
    *bytes = lseek(f->fd, 0, SEEK_END);
    return *bytes < 0 ? fail_file(f, CALL_File_get_size, file_error(errno), "%s", f->name) : MPI_SUCCESS;
}

/* --- what is known --- */

CALL(File_get_group, (MPI_File file, MPI_Group *group))
{
    struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_get_group);
    return PMPI_Comm_group(HANDLE(MPI_Comm, f->comm), group);
}

CALL(File_get_amode, (MPI_File file, int *amode))
{
    const struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_get_amode);
    *amode = f->amode;
    return MPI_SUCCESS;
}

/* Hints are kept, and have no effect. */
CALL(File_set_info, (MPI_File file, MPI_Info info))
{
    struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_set_info);
    return info_keep(&f->info, info);
}

CALL(File_get_info, (MPI_File file, MPI_Info *info))
{
    const struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_get_info);
    return info_give(f->info, info);
}

CALL(File_set_atomicity, (MPI_File file, int flag))
{
    struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_set_atomicity);
    f->atomic = flag != 0;
    return file_meet(f, CALL_File_set_atomicity, MPI_SUCCESS, NULL, 0);
}

CALL(File_get_atomicity, (MPI_File file, int *flag))
{
    const struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_get_atomicity);
    *flag = f->atomic;
    return MPI_SUCCESS;
}

/* What a write has moved is in the file for all nodes when the write is done. */
CALL(File_sync, (MPI_File file))
{
    struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_sync);
    return file_meet(f, CALL_File_sync, fsync(f->fd) ? file_error(errno) : MPI_SUCCESS, NULL, 0);
}

/* --- error handlers: MPI_FILE_NULL's is that of files that are opened from then on --- */

CALL(File_create_errhandler, (MPI_File_errhandler_function * function, MPI_Errhandler *handler))
{
    return PMPI_Comm_create_errhandler((MPI_Comm_errhandler_function *)(void *)function, handler);
}

static MPI_Errhandler *handler_of(MPI_File file)
{
    struct file *f = file_of(file);
    return f ? &f->handler : file == MPI_FILE_NULL ? &default_handler : NULL;
}

CALL(File_set_errhandler, (MPI_File file, MPI_Errhandler handler))
{
    MPI_Errhandler *of = handler_of(file);
    return of ? handler_set(CALL_File_set_errhandler, of, handler) : fail_no_file(CALL_File_set_errhandler);
}

CALL(File_get_errhandler, (MPI_File file, MPI_Errhandler *handler))
{
    const MPI_Errhandler *of = handler_of(file);
    if (!of)
        return fail_no_file(CALL_File_get_errhandler);
    *handler = handler_get(*of);
    return MPI_SUCCESS;
}

CALL(File_call_errhandler, (MPI_File file, int code))
{
    const MPI_Errhandler *of = handler_of(file);
    return of ? handler_call(CALL_File_call_errhandler, *of, &file, code)
              : fail_no_file(CALL_File_call_errhandler);
}
