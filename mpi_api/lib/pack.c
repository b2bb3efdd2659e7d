/* pack.c - the bytes of elements in order, out of memory and back. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include "lib.h"

/* Of those that may not lie together. */
void *type_made_together(const void *buf, int count, MPI_Datatype handle, size_t *bytes)
{
    const struct type *t = type_of(handle);
    *bytes = (size_t)count * t->size;
    if (t->runs > 1 || (count > 1 && type_extent(t) != (MPI_Aint)t->size))
        return NULL;
    return (char *)(uintptr_t)buf + t->run[0].at;
}

void type_pack(const void *buf, int count, MPI_Datatype handle, char *to)
{
    size_t bytes;
    const void *together = type_together(buf, count, handle, &bytes);
    if (together) {
        memcpy(to, together, bytes);
        return;
    }
    const struct type *t = type_of(handle);
    const char *element = buf;
    for (int i = 0; i < count; i++, element += type_extent(t))
        for (int k = 0; k < t->runs; k++) {
            memcpy(to, element + t->run[k].at, t->run[k].bytes);
            to += t->run[k].bytes;
        }
}

void type_unpack(const char *from, size_t bytes, void *buf, int count, MPI_Datatype handle)
{
    size_t whole;
    void *together = type_together(buf, count, handle, &whole);
    bytes = bytes < whole ? bytes : whole;
    if (together) {
        memcpy(together, from, bytes);
        return;
    }
    const struct type *t = type_of(handle);
    char *element = buf;
    for (; bytes; element += type_extent(t))
        for (int k = 0; k < t->runs && bytes; k++) {
            size_t some = t->run[k].bytes < bytes ? t->run[k].bytes : bytes;
            memcpy(element + t->run[k].at, from, some);
            from += some, bytes -= some;
        }
}

void type_copy(const void *from, int count, MPI_Datatype t, void *to, int room, MPI_Datatype as)
{
    size_t bytes, whole;
    const void *source = type_together(from, count, t, &bytes);
    void *target = type_together(to, room, as, &whole);
    if (source && target) {
        memmove(target, source, bytes < whole ? bytes : whole);
    } else if (source) {
        type_unpack(source, bytes, to, room, as);
    } else {
        char *packed = get_memory(bytes);
        type_pack(from, count, t, packed);
        type_unpack(packed, bytes, to, room, as);
        free(packed);
    }
}

/* --- the calls --- */

CALL(Pack,
     (const void *buf, int count, MPI_Datatype type, void *into, int room, int *position, MPI_Comm comm))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Pack);
    if (!type_is_valid(type))
        return fail(c, CALL_Pack, MPI_ERR_TYPE, "the datatype is null, freed, or not committed");
    size_t bytes = (size_t)count * size_of(type);
    if (count < 0 || *position < 0 || room < 0 || (size_t)*position + bytes > (size_t)room)
        return fail(c, CALL_Pack, count < 0 ? MPI_ERR_COUNT : MPI_ERR_TRUNCATE,
                    "%d elements of %zu bytes do not fit into %d bytes after position %d", count,
                    size_of(type), room, *position);
    type_pack(buf, count, type, (char *)into + *position);
    *position += (int)bytes;
    return MPI_SUCCESS;
}

CALL(Unpack,
     (const void *from, int size, int *position, void *buf, int count, MPI_Datatype type, MPI_Comm comm))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Unpack);
    if (!type_is_valid(type))
        return fail(c, CALL_Unpack, MPI_ERR_TYPE, "the datatype is null, freed, or not committed");
    size_t bytes = (size_t)count * size_of(type);
    if (count < 0 || *position < 0 || size < 0 || (size_t)*position + bytes > (size_t)size)
        return fail(c, CALL_Unpack, count < 0 ? MPI_ERR_COUNT : MPI_ERR_TRUNCATE,
                    "there are fewer than %d elements of %zu bytes in %d bytes after position %d", count,
                    size_of(type), size, *position);
    type_unpack((const char *)from + *position, bytes, buf, count, type);
    *position += (int)bytes;
    return MPI_SUCCESS;
}

CALL(Pack_size, (int count, MPI_Datatype type, MPI_Comm comm, int *size))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Pack_size);
    if (!type_of(type))
        return fail(c, CALL_Pack_size, MPI_ERR_TYPE, "the datatype is null, or freed");
    if (count < 0)
        return fail(c, CALL_Pack_size, MPI_ERR_COUNT, "the count %d is negative", count);
    size_t bytes = (size_t)count * size_of(type);
    *size = bytes > INT_MAX ? MPI_UNDEFINED : (int)bytes;
    return MPI_SUCCESS;
}

/* --- in the order of bytes that all computers agree on: each element's highest first --- */

/* A number, if all of it is there; what is behind it. */
static char *reverse(char *number, const char *end, int bytes)
{
    if (end - number < bytes)
        return number + (end - number);
    for (int low = 0, high = bytes - 1; low < high; low++, high--) {
        char c = number[low];
        number[low] = number[high], number[high] = c;
    }
    return number + bytes;
}

/* The numbers of elements; what is behind them. */
static char *reverse_elements(MPI_Datatype handle, size_t count, char *at, const char *end)
{
    const struct type *t = type_of(handle);
    const struct basic *b = type_basic(handle);
    const int numbers = b && b->class == COMPLEX ? 2 : 1;
    const bool is_struct = t->combiner == MPI_COMBINER_STRUCT;
    if (!b && !is_struct && t->size) /* as many of one other datatype as it has room for */
        return reverse_elements(t->type_list[0], count * (t->size / size_of(t->type_list[0])), at, end);
    for (; t->size && count && at < end; count--) {
        for (int i = 0; is_struct && i < t->types; i++)
            at = reverse_elements(t->type_list[i], (size_t)t->int_list[1 + i], at, end);
        for (int i = 0; b && i < t->runs * numbers; i++)
            at = reverse(at, end, t->run[i / numbers].unit / numbers);
    }
    return at;
}

void type_reverse(MPI_Datatype handle, char *packed, size_t bytes)
{
    reverse_elements(handle, bytes, packed, packed + bytes);
}

static int check_external(int call, const char *name, int count, MPI_Datatype type)
{
    if (strcmp(name, "external32") != 0)
        return fail(NULL, call, MPI_ERR_ARG, "there is the representation external32 only");
    if (count < 0)
        return fail(NULL, call, MPI_ERR_COUNT, "the count %d is negative", count);
    return type_of(type) ? MPI_SUCCESS : type_missing(call);
}

CALL(Pack_external_size, (const char name[], int count, MPI_Datatype type, MPI_Aint *size))
{
    int code = check_external(CALL_Pack_external_size, name, count, type);
    if (!code)
        *size = count * (MPI_Aint)size_of(type);
    return code;
}

CALL(Pack_external, (const char name[], const void *buf, int count, MPI_Datatype type, void *into,
                     MPI_Aint room, MPI_Aint *position))
{
    int code = check_external(CALL_Pack_external, name, count, type);
    if (code)
        return code;
    MPI_Aint bytes = count * (MPI_Aint)size_of(type);
    if (*position < 0 || *position + bytes > room)
        return fail(NULL, CALL_Pack_external, MPI_ERR_TRUNCATE,
                    "there is no room for %ld bytes after position %ld", (long)bytes, (long)*position);
    type_pack(buf, count, type, (char *)into + *position);
    type_reverse(type, (char *)into + *position, (size_t)bytes);
    *position += bytes;
    return MPI_SUCCESS;
}

CALL(Unpack_external, (const char name[], const void *from, MPI_Aint size, MPI_Aint *position, void *buf,
                       int count, MPI_Datatype type))
{
    int code = check_external(CALL_Unpack_external, name, count, type);
    if (code)
        return code;
    MPI_Aint bytes = count * (MPI_Aint)size_of(type);
    if (*position < 0 || *position + bytes > size)
        return fail(NULL, CALL_Unpack_external, MPI_ERR_TRUNCATE,
                    "fewer than %ld bytes are there after position %ld", (long)bytes, (long)*position);
    char *copy = get_memory((size_t)bytes);
    memcpy(copy, (const char *)from + *position, (size_t)bytes);
    type_reverse(type, copy, (size_t)bytes);
    type_unpack(copy, (size_t)bytes, buf, count, type);
    free(copy);
    *position += bytes;
    return MPI_SUCCESS;
}

/* --- what a status says of the bytes --- */

CALL(Get_count, (const MPI_Status *status, MPI_Datatype type, int *count))
{
    if (!type_of(type))
        return type_missing(CALL_Get_count);
    size_t bytes = status_bytes(status), size = size_of(type);
    if (!size)
        *count = bytes ? MPI_UNDEFINED : 0;
    else
        *count = bytes % size || bytes / size > INT_MAX ? MPI_UNDEFINED : (int)(bytes / size);
    return MPI_SUCCESS;
}

static int get_elements(int call, const MPI_Status *status, MPI_Datatype type, MPI_Count *count)
{
    const struct type *t = type_of(type);
    if (!t)
        return type_missing(call);
    size_t bytes = status_bytes(status), in_one = 0, n = 0;
    for (int k = 0; k < t->runs; k++)
        in_one += t->run[k].bytes / (size_t)t->run[k].unit;
    if (t->size) {
        n = bytes / t->size * in_one;
        bytes %= t->size;
    }
    for (int k = 0; bytes && k < t->runs; k++) {
        size_t some = t->run[k].bytes < bytes ? t->run[k].bytes : bytes, unit = (size_t)t->run[k].unit;
        n += some / unit;
        bytes -= some;
        if (some % unit)
            return *count = MPI_UNDEFINED, MPI_SUCCESS;
    }
    *count = (MPI_Count)n;
    return MPI_SUCCESS;
}

CALL(Get_elements_x, (const MPI_Status *status, MPI_Datatype type, MPI_Count *count))
{
    return get_elements(CALL_Get_elements_x, status, type, count);
}

CALL(Get_elements, (const MPI_Status *status, MPI_Datatype type, int *count))
{
    MPI_Count n;
    int code = get_elements(CALL_Get_elements, status, type, &n);
    *count = code || n > INT_MAX ? MPI_UNDEFINED : (int)n;
    return code;
}

static int set_elements(int call, MPI_Status *status, MPI_Datatype type, MPI_Count count)
{
    const struct type *t = type_of(type);
    if (!t)
        return type_missing(call);
    int cancelled = status->MPI_internal[2];
    status_set(status, status->MPI_SOURCE, status->MPI_TAG, (size_t)count * t->size);
    status->MPI_internal[2] = cancelled;
    return MPI_SUCCESS;
}

CALL(Status_set_elements_x, (MPI_Status * status, MPI_Datatype type, MPI_Count count))
{
    return set_elements(CALL_Status_set_elements_x, status, type, count);
}

CALL(Status_set_elements, (MPI_Status * status, MPI_Datatype type, int count))
{
    return set_elements(CALL_Status_set_elements, status, type, count);
}

CALL(Status_set_cancelled, (MPI_Status * status, int flag))
{
    status->MPI_internal[2] = flag != 0;
    return MPI_SUCCESS;
}

CALL(Test_cancelled, (const MPI_Status *status, int *flag))
{
    *flag = status->MPI_internal[2];
    return MPI_SUCCESS;
}
