/* file_views.c - the view of a file: which of its bytes a rank sees, in order. From the displacement on the
 * filetype is repeated, one extent after the other; the rank sees the bytes of its runs. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "files.h"

/* --- ranges --- */

struct view_walk view_walk(const struct file *f, MPI_Offset at, size_t bytes)
{
    const struct type *t = type_of(f->filetype);
    struct view_walk w = {.f = f, .t = t, .left = t->size ? bytes : 0};
    if (!t->size)
        return w;
    w.tile = at / (MPI_Offset)t->size, w.skip = (size_t)at % t->size;
    while (w.skip >= t->run[w.run].bytes)
        w.skip -= t->run[w.run++].bytes;
    return w;
}

static MPI_Offset place_of(const struct view_walk *w)
{
    return w->f->displacement + w->tile * type_extent(w->t) + w->t->run[w->run].at + (MPI_Offset)w->skip;
}

static void take(struct view_walk *w, size_t bytes)
{
    w->skip += bytes, w->left -= bytes;
    if (w->skip < w->t->run[w->run].bytes)
        return;
    w->skip = 0;
    if (++w->run == w->t->runs)
        w->run = 0, w->tile++;
}

bool view_next(struct view_walk *w, MPI_Offset *at, size_t *bytes)
{
    if (!w->left)
        return false;
    *at = place_of(w), *bytes = 0;
    if (w->t->runs == 1 && type_extent(w->t) == (MPI_Aint)w->t->size) { /* no holes: all of it */
        *bytes = w->left, w->left = 0;
        return true;
    }
    do {
        size_t rest = w->t->run[w->run].bytes - w->skip, some = rest < w->left ? rest : w->left;
        *bytes += some;
        take(w, some);
    } while (w->left && place_of(w) == *at + (MPI_Offset)*bytes);
    return true;
}

MPI_Offset view_end(const struct file *f)
{
    const struct type *t = type_of(f->filetype);
    MPI_Offset size = lseek(f->fd, 0, SEEK_END), etype = (MPI_Offset)size_of(f->etype);
    MPI_Offset behind = size - f->displacement, extent = type_extent(t);
    if (behind <= 0 || extent <= 0 || !etype)
        return size < 0 ? -1 : 0;
    MPI_Offset bytes = 0;
    for (int k = 0; k < t->runs; k++) {
        MPI_Offset seen = behind - t->run[k].at, all = (MPI_Offset)t->run[k].bytes;
        if (seen > 0)
            bytes += seen / extent * all + (seen % extent < all ? seen % extent : all);
    }
    return (bytes + etype - 1) / etype;
}

/* --- setting it --- */

static void view_set(struct file *f, MPI_Offset displacement, MPI_Datatype etype, MPI_Datatype filetype)
{
    type_keep(etype);
    type_keep(filetype);
    f->displacement = displacement, f->etype = etype, f->filetype = filetype;
}

void view_leave(struct file *f)
{
    type_leave(f->etype);
    type_leave(f->filetype);
}

void view_first(struct file *f)
{
    view_set(f, 0, MPI_BYTE, MPI_BYTE);
    f->datarep = datarep_named("native");
}

/* A type of a view has no bytes before its beginning, does not go back, and, in a file that is written, has
 * no byte twice. */
static bool goes_forward(const struct type *t, bool overlaps)
{
    MPI_Aint least = 0;
    for (int k = 0; k < t->runs; k++) {
        if (t->run[k].at < least)
            return false;
        least = t->run[k].at + (overlaps ? 0 : (MPI_Aint)t->run[k].bytes);
    }
    return true;
}

static int check_view(const struct file *f, MPI_Offset displacement, MPI_Datatype etype,
                      MPI_Datatype filetype, const char *representation)
{
    bool overlaps = f->amode & MPI_MODE_RDONLY, sequential = f->amode & MPI_MODE_SEQUENTIAL;
    if (!datarep_named(representation))
        return MPI_ERR_UNSUPPORTED_DATAREP;
    if (!type_is_valid(etype) || !type_is_valid(filetype))
        return MPI_ERR_TYPE;
    if (sequential ? displacement != MPI_DISPLACEMENT_CURRENT : displacement < 0)
        return MPI_ERR_ARG;
    if (!goes_forward(type_of(etype), overlaps) || !goes_forward(type_of(filetype), overlaps))
        return MPI_ERR_IO;
    size_t element = size_of(etype);
    return element && size_of(filetype) % element ? MPI_ERR_ARG : MPI_SUCCESS;
}

static int reset_shared(struct file *f, MPI_Offset unused)
{
    (void)unused;
    f->shared = 0;
    return MPI_SUCCESS;
}

static MPI_Offset byte_of(const struct file *f, MPI_Offset place)
{
    struct view_walk w = view_walk(f, place * (MPI_Offset)size_of(f->etype), 1);
    return w.left ? place_of(&w) : f->displacement;
}

CALL(File_set_view, (MPI_File file, MPI_Offset displacement, MPI_Datatype etype, MPI_Datatype filetype,
                     const char *representation, MPI_Info info))
{
    struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_set_view);
    int code = check_view(f, displacement, etype, filetype, representation);
    if (!code && displacement == MPI_DISPLACEMENT_CURRENT)
        displacement = byte_of(f, server_add(f, CALL_File_set_view, 0));
    code = file_meet(f, CALL_File_set_view, code, reset_shared, 0);
    if (code)
        return fail_file(
            f, CALL_File_set_view, code,
            "on this rank or another the displacement, a datatype or the representation is wrong");
    view_leave(f);
    view_set(f, displacement, etype, filetype);
    f->datarep = datarep_named(representation);
    f->external = strcmp(representation, "external32") == 0;
    f->pointer = 0;
    return info == MPI_INFO_NULL ? MPI_SUCCESS : PMPI_File_set_info(file, info);
}

/* A type of the program's as another handle, which it frees. */
static MPI_Datatype give(MPI_Datatype t)
{
    MPI_Datatype copy = t;
    if (!type_basic(t))
        PMPI_Type_dup(t, &copy);
    return copy;
}

CALL(File_get_view, (MPI_File file, MPI_Offset *displacement, MPI_Datatype *etype, MPI_Datatype *filetype,
                     char *representation))
{
    const struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_get_view);
    *displacement = f->displacement;
    *etype = give(f->etype), *filetype = give(f->filetype);
    strcpy(representation, datarep_name(f->datarep));
    return MPI_SUCCESS;
}

CALL(File_get_type_extent, (MPI_File file, MPI_Datatype type, MPI_Aint *extent))
{
    struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_get_type_extent);
    if (!type_of(type))
        return fail_file(f, CALL_File_get_type_extent, MPI_ERR_TYPE, "the datatype is null, or freed");
    return datarep_extent(f->datarep, type, extent);
}

/* --- places --- */

CALL(File_get_byte_offset, (MPI_File file, MPI_Offset place, MPI_Offset *bytes))
{
    struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_get_byte_offset);
    if (place < 0)
        return fail_file(f, CALL_File_get_byte_offset, MPI_ERR_ARG, "the place is negative");
    *bytes = byte_of(f, place);
    return MPI_SUCCESS;
}

/* Where `place` leads, from a pointer that is at `at`; -1: nowhere. */
static MPI_Offset lead(const struct file *f, MPI_Offset at, MPI_Offset place, int whence)
{
    MPI_Offset from = whence == MPI_SEEK_SET ? 0 : whence == MPI_SEEK_CUR ? at : view_end(f);
    if (whence != MPI_SEEK_SET && whence != MPI_SEEK_CUR && whence != MPI_SEEK_END)
        return -1;
    return from < 0 || from + place < 0 ? -1 : from + place;
}

static int bad_place(struct file *f, int call, MPI_Offset place)
{
    return fail_file(f, call, MPI_ERR_ARG, "the place %ld lies before the view, or from nowhere",
                     (long)place);
}

static int no_seek(struct file *f, int call)
{
    return fail_file(f, call, MPI_ERR_UNSUPPORTED_OPERATION, "the file is a sequential one");
}

CALL(File_seek, (MPI_File file, MPI_Offset place, int whence))
{
    struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_seek);
    if (f->amode & MPI_MODE_SEQUENTIAL)
        return no_seek(f, CALL_File_seek);
    MPI_Offset to = lead(f, f->pointer, place, whence);
    if (to < 0)
        return bad_place(f, CALL_File_seek, place);
    f->pointer = to;
    return MPI_SUCCESS;
}

CALL(File_get_position, (MPI_File file, MPI_Offset *place))
{
    const struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_get_position);
    *place = f->pointer;
    return MPI_SUCCESS;
}

static int lead_shared(struct file *f, MPI_Offset place, int whence)
{
    MPI_Offset to = lead(f, f->shared, place, whence);
    f->shared = to < 0 ? f->shared : to;
    return to < 0 ? MPI_ERR_ARG : MPI_SUCCESS;
}

static int from_start(struct file *f, MPI_Offset place)
{
    return lead_shared(f, place, MPI_SEEK_SET);
}

static int from_here(struct file *f, MPI_Offset place)
{
    return lead_shared(f, place, MPI_SEEK_CUR);
}

static int from_end(struct file *f, MPI_Offset place)
{
    return lead_shared(f, place, MPI_SEEK_END);
}

CALL(File_seek_shared, (MPI_File file, MPI_Offset place, int whence))
{
    struct file *f = file_of(file);
    file_work *work = whence == MPI_SEEK_SET ? from_start : whence == MPI_SEEK_CUR ? from_here : from_end;
    if (!f)
        return fail_no_file(CALL_File_seek_shared);
    if (f->amode & MPI_MODE_SEQUENTIAL)
        return no_seek(f, CALL_File_seek_shared);
    int code = whence < MPI_SEEK_SET || whence > MPI_SEEK_END ? MPI_ERR_ARG : MPI_SUCCESS;
    code = file_meet(f, CALL_File_seek_shared, code, work, place);
    return code ? bad_place(f, CALL_File_seek_shared, place) : MPI_SUCCESS;
}

CALL(File_get_position_shared, (MPI_File file, MPI_Offset *place))
{
    struct file *f = file_of(file);
    if (!f)
        return fail_no_file(CALL_File_get_position_shared);
    *place = server_add(f, CALL_File_get_position_shared, 0);
    return MPI_SUCCESS;
}
