/* datareps.c - representations of data in files: MPI's own, and those that the program registers. As in ROMIO
 * these convert nothing: the functions that would are refused. */
#include <stdlib.h>
#include <string.h>
#include "files.h"

struct datarep {
    const struct datarep *next;
    const char *name;
    MPI_Datarep_extent_function *extent; /* NULL: as in memory */
    void *extra;
};

static const struct datarep own[] = {
    {&own[1], "native", NULL, NULL}, {&own[2], "internal", NULL, NULL}, {NULL, "external32", NULL, NULL}};
static const struct datarep *all = own;

const struct datarep *datarep_named(const char *name)
{
    const struct datarep *r = all;
    while (r && strcmp(r->name, name) != 0)
        r = r->next;
    return r;
}

const char *datarep_name(const struct datarep *r)
{
    return r->name;
}

int datarep_extent(const struct datarep *r, MPI_Datatype type, MPI_Aint *extent)
{
    if (r->extent)
        return r->extent(type, extent, r->extra);
    *extent = extent_of(type);
    return MPI_SUCCESS;
}

CALL(Register_datarep,
     (const char *name, MPI_Datarep_conversion_function *read, MPI_Datarep_conversion_function *write,
      MPI_Datarep_extent_function *extent, void *extra))
{
    if (!name || !*name || strnlen(name, MPI_MAX_DATAREP_STRING) == MPI_MAX_DATAREP_STRING || !extent)
        return fail_file(NULL, CALL_Register_datarep, MPI_ERR_ARG,
                         "the name is empty or too long, or there is no function for extents");
    if (datarep_named(name))
        return fail_file(NULL, CALL_Register_datarep, MPI_ERR_DUP_DATAREP, "%s is there already", name);
    if (read != MPI_CONVERSION_FN_NULL || write != MPI_CONVERSION_FN_NULL)
        return fail_file(NULL, CALL_Register_datarep, MPI_ERR_CONVERSION,
                         "there are no conversions: the functions have to be "
                         "MPI_CONVERSION_FN_NULL");
    struct datarep *r = get_memory(sizeof *r);
    *r = (struct datarep){all, strdup(name), extent, extra};
    all = r;
    return MPI_SUCCESS;
}
