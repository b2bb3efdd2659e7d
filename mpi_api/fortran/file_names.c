/* file_names.c - Fortran's names for the calls on files. Places and sizes are INTEGERs of MPI_OFFSET_KIND. */
#include "fortran.h"

#define F_FILE(x) F_HANDLE(MPI_File, *(x))
#define F_INFO(x) F_HANDLE(MPI_Info, *(x))

FORTRAN(file_open,
        (f_int * comm, const char *name, f_int *amode, f_int *info, f_int *file, f_int *ierr, size_t length))
{
    char *text = f_text(name, length);
    WITH(MPI_File, file, MPI_File_open(F_COMM(comm), text, *amode, F_INFO(info), &handle));
    free(text);
}

FORTRAN(file_close, (f_int * file, f_int *ierr))
{
    WITH(MPI_File, file, MPI_File_close(&handle));
}

FORTRAN(file_delete, (const char *name, f_int *info, f_int *ierr, size_t length))
{
    char *text = f_text(name, length);
    IERR = MPI_File_delete(text, F_INFO(info));
    free(text);
}

/* --- calls that set a number, or ask for one --- */

#define SET(name, c_name, type)                                                                              \
    FORTRAN(name, (f_int * file, type * value, f_int * ierr))                                                \
    {                                                                                                        \
        IERR = MPI_##c_name(F_FILE(file), *value);                                                           \
    }
#define GET(name, c_name, type)                                                                              \
    FORTRAN(name, (f_int * file, type * value, f_int * ierr))                                                \
    {                                                                                                        \
        IERR = MPI_##c_name(F_FILE(file), value);                                                            \
    }
SET(file_set_size, File_set_size, MPI_Offset)
SET(file_preallocate, File_preallocate, MPI_Offset)
SET(file_set_atomicity, File_set_atomicity, f_int)
SET(file_call_errhandler, File_call_errhandler, f_int)
GET(file_get_size, File_get_size, MPI_Offset)
GET(file_get_position, File_get_position, MPI_Offset)
GET(file_get_position_shared, File_get_position_shared, MPI_Offset)
GET(file_get_atomicity, File_get_atomicity, f_int)
GET(file_get_amode, File_get_amode, f_int)

FORTRAN(file_get_group, (f_int * file, f_int *group, f_int *ierr))
{
    WITH(MPI_Group, group, MPI_File_get_group(F_FILE(file), &handle));
}

FORTRAN(file_set_info, (f_int * file, f_int *info, f_int *ierr))
{
    IERR = MPI_File_set_info(F_FILE(file), F_INFO(info));
}

FORTRAN(file_get_info, (f_int * file, f_int *info, f_int *ierr))
{
    WITH(MPI_Info, info, MPI_File_get_info(F_FILE(file), &handle));
}

FORTRAN(file_sync, (f_int * file, f_int *ierr))
{
    IERR = MPI_File_sync(F_FILE(file));
}

FORTRAN(file_create_errhandler, (MPI_File_errhandler_function * function, f_int *handler, f_int *ierr))
{
    WITH(MPI_Errhandler, handler, MPI_File_create_errhandler(function, &handle));
}

FORTRAN(file_set_errhandler, (f_int * file, f_int *handler, f_int *ierr))
{
    IERR = MPI_File_set_errhandler(F_FILE(file), F_HANDLE(MPI_Errhandler, *handler));
}

FORTRAN(file_get_errhandler, (f_int * file, f_int *handler, f_int *ierr))
{
    WITH(MPI_Errhandler, handler, MPI_File_get_errhandler(F_FILE(file), &handle));
}

/* --- views and places --- */

FORTRAN(file_set_view, (f_int * file, MPI_Offset *displacement, f_int *etype, f_int *filetype,
                        const char *representation, f_int *info, f_int *ierr, size_t length))
{
    char *text = f_text(representation, length);
    IERR =
        MPI_File_set_view(F_FILE(file), *displacement, F_TYPE(etype), F_TYPE(filetype), text, F_INFO(info));
    free(text);
}

FORTRAN(file_get_view, (f_int * file, MPI_Offset *displacement, f_int *etype, f_int *filetype,
                        char *representation, f_int *ierr, size_t room))
{
    char text[MPI_MAX_DATAREP_STRING];
    MPI_Datatype types[2];
    IERR = MPI_File_get_view(F_FILE(file), displacement, &types[0], &types[1], text);
    if (IERR)
        return;
    *etype = F_OF(types[0]), *filetype = F_OF(types[1]);
    f_give_text(representation, room, text);
}

FORTRAN(file_get_type_extent, (f_int * file, f_int *type, MPI_Aint *extent, f_int *ierr))
{
    IERR = MPI_File_get_type_extent(F_FILE(file), F_TYPE(type), extent);
}

FORTRAN(file_seek, (f_int * file, MPI_Offset *place, f_int *whence, f_int *ierr))
{
    IERR = MPI_File_seek(F_FILE(file), *place, *whence);
}

FORTRAN(file_seek_shared, (f_int * file, MPI_Offset *place, f_int *whence, f_int *ierr))
{
    IERR = MPI_File_seek_shared(F_FILE(file), *place, *whence);
}

FORTRAN(file_get_byte_offset, (f_int * file, MPI_Offset *place, MPI_Offset *bytes, f_int *ierr))
{
    IERR = MPI_File_get_byte_offset(F_FILE(file), *place, bytes);
}

/* --- reading and writing --- */

#define HERE(name, c_name)                                                                                   \
    FORTRAN(name, (f_int * file, void *buf, f_int *count, f_int *type, f_int *status, f_int *ierr))          \
    {                                                                                                        \
        IERR = MPI_##c_name(F_FILE(file), f_buffer(buf), *count, F_TYPE(type), f_status(status));            \
    }
#define HERE_LATER(name, c_name)                                                                             \
    FORTRAN(name, (f_int * file, void *buf, f_int *count, f_int *type, f_int *request, f_int *ierr))         \
    {                                                                                                        \
        WITH(MPI_Request, request,                                                                           \
             MPI_##c_name(F_FILE(file), f_buffer(buf), *count, F_TYPE(type), &handle));                      \
    }
#define THERE(name, c_name)                                                                                  \
    FORTRAN(name, (f_int * file, MPI_Offset * place, void *buf, f_int *count, f_int *type, f_int *status,    \
                   f_int *ierr))                                                                             \
    {                                                                                                        \
        IERR = MPI_##c_name(F_FILE(file), *place, f_buffer(buf), *count, F_TYPE(type), f_status(status));    \
    }
#define THERE_LATER(name, c_name)                                                                            \
    FORTRAN(name, (f_int * file, MPI_Offset * place, void *buf, f_int *count, f_int *type, f_int *request,   \
                   f_int *ierr))                                                                             \
    {                                                                                                        \
        WITH(MPI_Request, request,                                                                           \
             MPI_##c_name(F_FILE(file), *place, f_buffer(buf), *count, F_TYPE(type), &handle));              \
    }
#define SECOND(name, c_name)                                                                                 \
    FORTRAN(name, (f_int * file, void *buf, f_int *status, f_int *ierr))                                     \
    {                                                                                                        \
        IERR = MPI_##c_name(F_FILE(file), f_buffer(buf), f_status(status));                                  \
    }
#define FIRST(name, c_name)                                                                                  \
    FORTRAN(name, (f_int * file, void *buf, f_int *count, f_int *type, f_int *ierr))                         \
    {                                                                                                        \
        IERR = MPI_##c_name(F_FILE(file), f_buffer(buf), *count, F_TYPE(type));                              \
    }
#define FIRST_THERE(name, c_name)                                                                            \
    FORTRAN(name, (f_int * file, MPI_Offset * place, void *buf, f_int *count, f_int *type, f_int *ierr))     \
    {                                                                                                        \
        IERR = MPI_##c_name(F_FILE(file), *place, f_buffer(buf), *count, F_TYPE(type));                      \
    }
#define CALLS(way)                                                                                           \
    HERE(file_##way, File_##way)                                                                             \
    HERE(file_##way##_all, File_##way##_all)                                                                 \
    HERE(file_##way##_shared, File_##way##_shared)                                                           \
    HERE(file_##way##_ordered, File_##way##_ordered)                                                         \
    HERE_LATER(file_i##way, File_i##way)                                                                     \
    HERE_LATER(file_i##way##_all, File_i##way##_all)                                                         \
    HERE_LATER(file_i##way##_shared, File_i##way##_shared)                                                   \
    THERE(file_##way##_at, File_##way##_at)                                                                  \
    THERE(file_##way##_at_all, File_##way##_at_all)                                                          \
    THERE_LATER(file_i##way##_at, File_i##way##_at)                                                          \
    THERE_LATER(file_i##way##_at_all, File_i##way##_at_all)                                                  \
    FIRST(file_##way##_all_begin, File_##way##_all_begin)                                                    \
    FIRST(file_##way##_ordered_begin, File_##way##_ordered_begin)                                            \
    FIRST_THERE(file_##way##_at_all_begin, File_##way##_at_all_begin)                                        \
    SECOND(file_##way##_all_end, File_##way##_all_end)                                                       \
    SECOND(file_##way##_ordered_end, File_##way##_ordered_end)                                               \
    SECOND(file_##way##_at_all_end, File_##way##_at_all_end)
CALLS(read)
CALLS(write)

/* --- representations of data --- */

/* The function for extents is Fortran's. */
struct f_datarep {
    void (*extent)(f_int *type, MPI_Aint *extent, MPI_Aint *extra, f_int *ierr);
    MPI_Aint extra;
};

static int extent_in_file(MPI_Datatype type, MPI_Aint *extent, void *extra)
{
    struct f_datarep *r = extra;
    f_int handle = F_OF(type), code = MPI_SUCCESS;
    r->extent(&handle, extent, &r->extra, &code);
    return code;
}

/* Stands for MPI_CONVERSION_FN_NULL, and is never called. */
void mpi_conversion_fn_null_(void);
void mpi_conversion_fn_null_(void) {}

static MPI_Datarep_conversion_function *conversion(void (*function)(void))
{
    return function == mpi_conversion_fn_null_ ? MPI_CONVERSION_FN_NULL
                                               : (MPI_Datarep_conversion_function *)(void *)function;
}

FORTRAN(register_datarep, (const char *name, void (*read)(void), void (*write)(void),
                           void (*extent)(f_int *, MPI_Aint *, MPI_Aint *, f_int *), MPI_Aint *extra,
                           f_int *ierr, size_t length))
{
    char *text = f_text(name, length);
    struct f_datarep *r = get_memory(sizeof *r); /* as long as the representation */
    *r = (struct f_datarep){extent, *extra};
    IERR = MPI_Register_datarep(text, conversion(read), conversion(write), extent_in_file, r);
    if (IERR)
        free(r);
    free(text);
}
