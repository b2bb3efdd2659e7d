/* datatypes.c - each datatype is a list of runs of bytes, in the order of its type map, and two bounds. */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lib.h"

/* --- MPI's own --- */

#define AT(handle) [(handle)-FIRST_BASIC]
const struct basic basic_types[BASICS] = {
    AT(0x201) = {8, WHOLE, 0},    AT(0x202) = {8, WHOLE, 0},    AT(0x203) = {8, WHOLE, 0},
    AT(0x207) = {1, BITS, 0},     AT(0x208) = {2, WHOLE, 0},    AT(0x209) = {4, WHOLE, 0},
    AT(0x20a) = {8, WHOLE, 0},    AT(0x20b) = {8, WHOLE, 0},    AT(0x20c) = {2, NATURAL, 0},
    AT(0x20d) = {4, NATURAL, 0},  AT(0x20e) = {8, NATURAL, 0},  AT(0x20f) = {8, NATURAL, 0},
    AT(0x210) = {4, REAL, 0},     AT(0x212) = {8, COMPLEX, 0},  AT(0x214) = {8, REAL, 0},
    AT(0x216) = {16, COMPLEX, 0}, AT(0x218) = {4, LOGICAL, 0},  AT(0x219) = {4, WHOLE, 0},
    AT(0x21a) = {4, REAL, 0},     AT(0x21b) = {8, COMPLEX, 0},  AT(0x21c) = {8, REAL, 0},
    AT(0x21d) = {16, COMPLEX, 0}, AT(0x220) = {16, REAL, 0},    AT(0x224) = {32, COMPLEX, 0},
    AT(0x228) = {8, PAIR, 4},     AT(0x229) = {16, PAIR, 8},    AT(0x22a) = {16, PAIR, 8},
    AT(0x22b) = {8, PAIR, 4},     AT(0x22c) = {8, PAIR, 2},     AT(0x22d) = {32, PAIR, 16},
    AT(0x230) = {8, PAIR, 4},     AT(0x231) = {16, PAIR, 8},    AT(0x232) = {8, PAIR, 4},
    AT(0x238) = {1, LOGICAL, 0},  AT(0x23c) = {4, WHOLE, 0},    AT(0x240) = {1, WHOLE, 0},
    AT(0x241) = {1, NATURAL, 0},  AT(0x243) = {1, WHOLE, 0},    AT(0x244) = {1, WHOLE, 0},
    AT(0x245) = {1, NATURAL, 0},  AT(0x247) = {1, BITS, 0},     AT(0x248) = {2, WHOLE, 0},
    AT(0x249) = {2, NATURAL, 0},  AT(0x250) = {4, WHOLE, 0},    AT(0x251) = {4, NATURAL, 0},
    AT(0x258) = {8, WHOLE, 0},    AT(0x259) = {8, NATURAL, 0},  AT(0x2c1) = {1, WHOLE, 0},
    AT(0x2c3) = {1, BITS, 0},     AT(0x2c9) = {2, WHOLE, 0},    AT(0x2d0) = {4, LOGICAL, 0},
    AT(0x2d1) = {4, WHOLE, 0},    AT(0x2d2) = {4, REAL, 0},     AT(0x2d8) = {8, LOGICAL, 0},
    AT(0x2d9) = {8, WHOLE, 0},    AT(0x2da) = {8, REAL, 0},     AT(0x2db) = {8, COMPLEX, 0},
    AT(0x2e2) = {16, REAL, 0},    AT(0x2e3) = {16, COMPLEX, 0}, AT(0x2f0) = {0, BITS, 0},
    AT(0x2f1) = {0, BITS, 0},     AT(0x213) = {8, COMPLEX, 0},  AT(0x217) = {16, COMPLEX, 0},
    AT(0x225) = {32, COMPLEX, 0}, AT(0x239) = {1, LOGICAL, 0},  AT(0x2e1) = {16, BITS, 0},
    AT(0x2eb) = {32, COMPLEX, 0},
};

/* Where the second member of a pair lies. */
static int pair_second_at(const struct basic *b)
{
    return b->value < 4 ? 4 : b->value;
}

/* The second member of the Fortran pairs is as long as the first. */
static int pair_second_bytes(uintptr_t handle, const struct basic *b)
{
    return handle >= 0x230 ? b->value : 4;
}

static struct type *basic_made[BASICS];

static struct type *make_basic(uintptr_t handle)
{
    const struct basic *b = &basic_types[handle - FIRST_BASIC];
    struct type *t = calloc(1, sizeof *t);
    if (!t)
        nxm_fail(CALL_Other, "the node has no memory left for MPI's datatypes");
    t->object = (struct object){TYPE, 1, (int)handle};
    t->ub = t->true_ub = b->bytes;
    t->size = b->bytes;
    t->align = b->class == COMPLEX ? b->bytes / 2 : b->class == PAIR ? b->value : b->bytes;
    t->runs = b->bytes ? 1 : 0;
    t->run = &t->one;
    t->one = (struct run){0, b->bytes, b->bytes};
    t->committed = true, t->combiner = MPI_COMBINER_NAMED;
    t->has_lb = handle == (uintptr_t)MPI_LB, t->has_ub = handle == (uintptr_t)MPI_UB;
    if (b->class == PAIR) {
        int second = pair_second_bytes(handle, b);
        t->runs = 2;
        t->run = get_memory(2 * sizeof *t->run);
        t->run[0] = (struct run){0, b->value, b->value};
        t->run[1] = (struct run){pair_second_at(b), (size_t)second, second};
        t->size = b->value + (size_t)second;
        t->true_ub = t->run[1].at + second;
    }
    return basic_made[handle - FIRST_BASIC] = t;
}

struct type *type_of(MPI_Datatype handle)
{
    if (!type_basic(handle))
        return object_of(handle, TYPE);
    struct type *t = basic_made[(uintptr_t)handle - FIRST_BASIC];
    return t ? t : make_basic((uintptr_t)handle);
}

bool type_is_valid(MPI_Datatype handle)
{
    if (type_basic(handle))
        return true;
    const struct type *t = object_of(handle, TYPE);
    return t && t->committed;
}

MPI_Aint extent_of(MPI_Datatype handle)
{
    const struct basic *b = type_basic(handle);
    return b ? b->bytes : type_extent(type_of(handle));
}

size_t size_of(MPI_Datatype handle)
{
    const struct basic *b = type_basic(handle);
    return b && b->class != PAIR ? b->bytes : type_of(handle)->size;
}

/* --- making --- */

static struct type *type_new(void)
{
    struct type *t = object_new(TYPE, sizeof *t);
    t->lb = t->true_lb = PTRDIFF_MAX, t->ub = t->true_ub = PTRDIFF_MIN;
    return t;
}

static void add_run(struct type *t, int *room, struct run r)
{
    struct run *last = t->runs ? &t->run[t->runs - 1] : NULL;
    if (!r.bytes)
        return;
    if (last && last->unit == r.unit && last->at + (MPI_Aint)last->bytes == r.at) {
        last->bytes += r.bytes;
        return;
    }
    if (t->runs == *room) {
        *room = *room ? 2 * *room : 4;
        t->run = realloc(t->run, (size_t)*room * sizeof *t->run);
        if (!t->run)
            nxm_fail(CALL_Other, "the node has no memory left for MPI's datatypes");
    }
    t->run[t->runs++] = r;
}

/* Adds `count` elements of old, one extent after the other, from `at` on. */
static void add_block(struct type *t, int *room, const struct type *old, int count, MPI_Aint at)
{
    MPI_Aint extent = type_extent(old);
    for (int i = 0; i < count; i++) {
        MPI_Aint here = at + i * extent;
        for (int k = 0; k < old->runs; k++)
            add_run(t, room, (struct run){here + old->run[k].at, old->run[k].bytes, old->run[k].unit});
        t->size += old->size;
    }
    if (count <= 0)
        return;
    MPI_Aint first = at, last = at + (count - 1) * extent;
    MPI_Aint low = extent < 0 ? last : first, high = extent < 0 ? first : last;
    bool marks = !old->size && (old->has_lb || old->has_ub);
    t->align = old->align > t->align ? old->align : t->align;
    if (marks ? old->has_lb : old->has_lb || !t->has_lb) {
        MPI_Aint lb = low + old->lb;
        t->lb = (old->has_lb && !t->has_lb) || lb < t->lb ? lb : t->lb;
        t->has_lb = t->has_lb || old->has_lb;
    }
    if (marks ? old->has_ub : old->has_ub || !t->has_ub) {
        MPI_Aint ub = high + old->ub;
        t->ub = (old->has_ub && !t->has_ub) || ub > t->ub ? ub : t->ub;
        t->has_ub = t->has_ub || old->has_ub;
    }
    if (!marks) {
        t->true_lb = low + old->true_lb < t->true_lb ? low + old->true_lb : t->true_lb;
        t->true_ub = high + old->true_ub > t->true_ub ? high + old->true_ub : t->true_ub;
    }
}

/* All blocks are there. padded: a struct's end is aligned as a C compiler does. */
static MPI_Datatype finish(struct type *t, int combiner, bool padded)
{
    if (t->lb == PTRDIFF_MAX)
        t->lb = 0;
    if (t->ub == PTRDIFF_MIN)
        t->ub = 0;
    if (t->true_lb == PTRDIFF_MAX)
        t->true_lb = t->true_ub = 0;
    if (padded && !t->has_ub && t->align && (t->ub - t->lb) % t->align)
        t->ub += t->align - (t->ub - t->lb) % t->align;
    if (!t->run)
        t->run = &t->one;
    t->combiner = combiner;
    return HANDLE(MPI_Datatype, t);
}

/* Keeps what the type was made of. */
static void keep(struct type *t, int ints, int addresses, int types)
{
    t->ints = ints, t->addresses = addresses, t->types = types;
    t->int_list = get_memory((size_t)ints * sizeof *t->int_list);
    t->address_list = get_memory((size_t)addresses * sizeof *t->address_list);
    t->type_list = get_memory((size_t)types * sizeof *t->type_list);
}

static void keep_type(struct type *t, int i, MPI_Datatype old)
{
    t->type_list[i] = old;
    type_keep(old);
}

static int no_type(const char *call)
{
    return fail(NULL, CALL_Other, MPI_ERR_TYPE, "%s: the datatype is null, or freed", call);
}

static int bad_count(const char *call, int count)
{
    return fail(NULL, CALL_Other, MPI_ERR_COUNT, "%s: the count %d is negative", call, count);
}

CALL(Type_contiguous, (int count, MPI_Datatype old, MPI_Datatype *type))
{
    const struct type *o = type_of(old);
    int room = 0;
    if (!o)
        return no_type("MPI_Type_contiguous");
    if (count < 0)
        return bad_count("MPI_Type_contiguous", count);
    struct type *t = type_new();
    add_block(t, &room, o, count, 0);
    keep(t, 1, 0, 1);
    t->int_list[0] = count;
    keep_type(t, 0, old);
    *type = finish(t, MPI_COMBINER_CONTIGUOUS, false);
    return MPI_SUCCESS;
}

static struct type *strided(int count, int length, MPI_Aint bytes, const struct type *o)
{
    struct type *t = type_new();
    int room = 0;
    for (int i = 0; i < count; i++)
        add_block(t, &room, o, length, i * bytes);
    return t;
}

CALL(Type_vector, (int count, int length, int stride, MPI_Datatype old, MPI_Datatype *type))
{
    const struct type *o = type_of(old);
    if (!o)
        return no_type("MPI_Type_vector");
    if (count < 0 || length < 0)
        return bad_count("MPI_Type_vector", count < 0 ? count : length);
    struct type *t = strided(count, length, stride * type_extent(o), o);
    keep(t, 3, 0, 1);
    t->int_list[0] = count, t->int_list[1] = length, t->int_list[2] = stride;
    keep_type(t, 0, old);
    *type = finish(t, MPI_COMBINER_VECTOR, false);
    return MPI_SUCCESS;
}

CALL(Type_create_hvector, (int count, int length, MPI_Aint stride, MPI_Datatype old, MPI_Datatype *type))
{
    const struct type *o = type_of(old);
    if (!o)
        return no_type("MPI_Type_create_hvector");
    if (count < 0 || length < 0)
        return bad_count("MPI_Type_create_hvector", count < 0 ? count : length);
    struct type *t = strided(count, length, stride, o);
    keep(t, 2, 1, 1);
    t->int_list[0] = count, t->int_list[1] = length, t->address_list[0] = stride;
    keep_type(t, 0, old);
    *type = finish(t, MPI_COMBINER_HVECTOR, false);
    return MPI_SUCCESS;
}

/* Blocks at places: of one length if lengths is NULL; places in elements, or in bytes. */
struct places {
    int count, length;
    const int *lengths, *elements;
    const MPI_Aint *bytes;
};

static int indexed(const char *call, const struct places *p, MPI_Datatype old, int combiner,
                   MPI_Datatype *type)
{
    const struct type *o = type_of(old);
    int room = 0, at = 0;
    if (!o)
        return no_type(call);
    if (p->count < 0)
        return bad_count(call, p->count);
    struct type *t = type_new();
    keep(t, 1 + (p->lengths ? p->count : 1) + (p->elements ? p->count : 0), p->elements ? 0 : p->count, 1);
    t->int_list[at++] = p->count;
    if (!p->lengths)
        t->int_list[at++] = p->length;
    for (int i = 0; p->lengths && i < p->count; i++)
        t->int_list[at++] = p->lengths[i];
    for (int i = 0; i < p->count; i++) {
        MPI_Aint place = p->elements ? p->elements[i] * type_extent(o) : p->bytes[i];
        if (p->elements)
            t->int_list[at++] = p->elements[i];
        else
            t->address_list[i] = place;
        add_block(t, &room, o, p->lengths ? p->lengths[i] : p->length, place);
    }
    keep_type(t, 0, old);
    *type = finish(t, combiner, false);
    return MPI_SUCCESS;
}

CALL(Type_indexed, (int count, const int lengths[], const int at[], MPI_Datatype old, MPI_Datatype *type))
{
    return indexed("MPI_Type_indexed", &(struct places){count, 0, lengths, at, NULL}, old,
                   MPI_COMBINER_INDEXED, type);
}

CALL(Type_create_hindexed,
     (int count, const int lengths[], const MPI_Aint at[], MPI_Datatype old, MPI_Datatype *type))
{
    return indexed("MPI_Type_create_hindexed", &(struct places){count, 0, lengths, NULL, at}, old,
                   MPI_COMBINER_HINDEXED, type);
}

CALL(Type_create_indexed_block, (int count, int length, const int at[], MPI_Datatype old, MPI_Datatype *type))
{
    return indexed("MPI_Type_create_indexed_block", &(struct places){count, length, NULL, at, NULL}, old,
                   MPI_COMBINER_INDEXED_BLOCK, type);
}

CALL(Type_create_hindexed_block,
     (int count, int length, const MPI_Aint at[], MPI_Datatype old, MPI_Datatype *type))
{
    return indexed("MPI_Type_create_hindexed_block", &(struct places){count, length, NULL, NULL, at}, old,
                   MPI_COMBINER_HINDEXED_BLOCK, type);
}

CALL(Type_create_struct,
     (int count, const int lengths[], const MPI_Aint at[], const MPI_Datatype types[], MPI_Datatype *type))
{
    int room = 0;
    if (count < 0)
        return bad_count("MPI_Type_create_struct", count);
    for (int i = 0; i < count; i++)
        if (!type_of(types[i]))
            return no_type("MPI_Type_create_struct");
    struct type *t = type_new();
    keep(t, 1 + count, count, count);
    t->int_list[0] = count;
    for (int i = 0; i < count; i++) {
        t->int_list[1 + i] = lengths[i], t->address_list[i] = at[i];
        keep_type(t, i, types[i]);
        add_block(t, &room, type_of(types[i]), lengths[i], at[i]);
    }
    *type = finish(t, MPI_COMBINER_STRUCT, true);
    return MPI_SUCCESS;
}

CALL(Type_create_resized, (MPI_Datatype old, MPI_Aint lb, MPI_Aint extent, MPI_Datatype *type))
{
    const struct type *o = type_of(old);
    int room = 0;
    if (!o)
        return no_type("MPI_Type_create_resized");
    struct type *t = type_new();
    add_block(t, &room, o, 1, 0);
    t->lb = lb, t->ub = lb + extent, t->has_lb = t->has_ub = true;
    keep(t, 0, 2, 1);
    t->address_list[0] = lb, t->address_list[1] = extent;
    keep_type(t, 0, old);
    *type = finish(t, MPI_COMBINER_RESIZED, false);
    return MPI_SUCCESS;
}

static void drop_inner(struct type *t)
{
    object_leave(&t->object);
    free(t->run);
    free(t);
}

/* A block of an array: from the dimension that varies fastest on, each makes a row of what is below it. */
CALL(Type_create_subarray, (int dims, const int sizes[], const int subsizes[], const int starts[], int order,
                            MPI_Datatype old, MPI_Datatype *type))
{
    const struct type *o = type_of(old);
    if (!o)
        return no_type("MPI_Type_create_subarray");
    MPI_Aint step = type_extent(o), at = 0, whole = step;
    struct type *inner = NULL;
    for (int k = 0; k < dims; k++) {
        int d = order == MPI_ORDER_FORTRAN ? k : dims - 1 - k, room = 0;
        if (sizes[d] < 1 || subsizes[d] < 1 || starts[d] < 0 || starts[d] + subsizes[d] > sizes[d])
            return fail(NULL, CALL_Other, MPI_ERR_ARG,
                        "MPI_Type_create_subarray: dimension %d has %d elements; %d from %d on are asked for",
                        d, sizes[d], subsizes[d], starts[d]);
        struct type *t = type_new();
        for (int i = 0; i < subsizes[d]; i++)
            add_block(t, &room, inner ? inner : o, 1, i * whole);
        at += starts[d] * whole;
        whole *= sizes[d];
        if (inner)
            drop_inner(inner);
        inner = t;
    }
    struct type *t = type_new();
    int room = 0;
    add_block(t, &room, inner, 1, at);
    drop_inner(inner);
    t->lb = 0, t->ub = whole, t->has_lb = t->has_ub = true;
    keep(t, 2 + 3 * dims, 0, 1);
    t->int_list[0] = dims, t->int_list[1 + 3 * dims] = order;
    for (int d = 0; d < dims; d++) {
        t->int_list[1 + d] = sizes[d];
        t->int_list[1 + dims + d] = subsizes[d];
        t->int_list[1 + 2 * dims + d] = starts[d];
    }
    keep_type(t, 0, old);
    *type = finish(t, MPI_COMBINER_SUBARRAY, false);
    return MPI_SUCCESS;
}

/* The elements of a dimension that a rank has: every so many blocks one of `block`. */
static struct type *distributed(const struct type *inner, MPI_Aint step, int size, int block, int parts,
                                int part)
{
    struct type *t = type_new();
    int room = 0;
    for (long first = (long)part * block; first < size; first += (long)parts * block)
        for (long i = first; i < first + block && i < size; i++)
            add_block(t, &room, inner, 1, i * step);
    return t;
}

CALL(Type_create_darray,
     (int ranks, int rank, int dims, const int sizes[], const int kinds[], const int blocks[],
      const int grid[], int order, MPI_Datatype old, MPI_Datatype *type))
{
    const struct type *o = type_of(old);
    if (!o)
        return no_type("MPI_Type_create_darray");
    MPI_Aint step = type_extent(o);
    struct type *inner = NULL;
    int coords[dims + 1], left = rank, room = 0;
    for (int d = dims - 1; d >= 0; d--) {
        coords[d] = left % grid[d];
        left /= grid[d];
    }
    for (int k = 0; k < dims; k++) {
        int d = order == MPI_ORDER_FORTRAN ? k : dims - 1 - k, block = blocks[d];
        if (kinds[d] == MPI_DISTRIBUTE_NONE)
            block = sizes[d];
        else if (block == MPI_DISTRIBUTE_DFLT_DARG)
            block = kinds[d] == MPI_DISTRIBUTE_BLOCK ? (sizes[d] + grid[d] - 1) / grid[d] : 1;
        struct type *t = distributed(inner ? inner : o, step, sizes[d], block,
                                     kinds[d] == MPI_DISTRIBUTE_NONE ? 1 : grid[d],
                                     kinds[d] == MPI_DISTRIBUTE_NONE ? 0 : coords[d]);
        if (inner)
            drop_inner(inner);
        inner = t;
        step *= sizes[d];
    }
    struct type *t = type_new();
    add_block(t, &room, inner, 1, 0);
    drop_inner(inner);
    t->lb = 0, t->ub = step, t->has_lb = t->has_ub = true;
    keep(t, 4 + 4 * dims, 0, 1);
    t->int_list[0] = ranks, t->int_list[1] = rank, t->int_list[2] = dims, t->int_list[3 + 4 * dims] = order;
    for (int d = 0; d < dims; d++) {
        const int *lists[] = {sizes, kinds, blocks, grid};
        for (int i = 0; i < 4; i++)
            t->int_list[3 + i * dims + d] = lists[i][d];
    }
    keep_type(t, 0, old);
    *type = finish(t, MPI_COMBINER_DARRAY, false);
    return MPI_SUCCESS;
}

CALL(Type_dup, (MPI_Datatype old, MPI_Datatype *type))
{
    struct type *o = type_of(old);
    int room = 0, code;
    if (!o)
        return no_type("MPI_Type_dup");
    struct type *t = type_new();
    add_block(t, &room, o, 1, 0);
    t->lb = o->lb, t->ub = o->ub, t->has_lb = o->has_lb, t->has_ub = o->has_ub;
    keep(t, 0, 0, 1);
    keep_type(t, 0, old);
    *type = finish(t, MPI_COMBINER_DUP, false);
    t->committed = o->committed;
    code = type_copy_attributes(o, t);
    if (code) {
        type_leave(*type);
        *type = MPI_DATATYPE_NULL;
    }
    return code;
}

CALL(Type_commit, (MPI_Datatype * type))
{
    struct type *t = type_of(*type);
    if (!t)
        return no_type("MPI_Type_commit");
    t->committed = true;
    return MPI_SUCCESS;
}

void type_keep(MPI_Datatype handle)
{
    struct type *t = type_basic(handle) ? NULL : object_of(handle, TYPE);
    if (t)
        t->object.users++;
}

void type_leave(MPI_Datatype handle)
{
    struct type *t = type_basic(handle) ? NULL : object_of(handle, TYPE);
    if (!t || !object_leave(&t->object))
        return;
    for (int i = 0; i < t->types; i++)
        type_leave(t->type_list[i]);
    free(t->int_list);
    free(t->address_list);
    free(t->type_list);
    free(t->name);
    if (t->run != &t->one)
        free(t->run);
    free(t);
}

CALL(Type_free, (MPI_Datatype * type))
{
    struct type *t = type_basic(*type) ? NULL : object_of(*type, TYPE);
    if (!t)
        return type_basic(*type)
                   ? fail(NULL, CALL_Other, MPI_ERR_TYPE, "MPI_Type_free: one of MPI's own types")
                   : no_type("MPI_Type_free");
    int code = type_delete_attributes(t);
    if (code)
        return code;
    type_leave(*type);
    *type = MPI_DATATYPE_NULL;
    return MPI_SUCCESS;
}

/* --- asking --- */

#define GET(name, type_of_value, expression)                                                                 \
    CALL(name, (MPI_Datatype type, type_of_value * value))                                                   \
    {                                                                                                        \
        const struct type *t = type_of(type);                                                                \
        if (!t)                                                                                              \
            return no_type("MPI_" #name);                                                                    \
        *value = (type_of_value)(expression);                                                                \
        return MPI_SUCCESS;                                                                                  \
    }
GET(Type_size, int, t->size > INT_MAX ? (size_t)MPI_UNDEFINED : t->size)
GET(Type_size_x, MPI_Count, t->size)
GET(Type_extent, MPI_Aint, type_extent(t))
GET(Type_lb, MPI_Aint, t->lb)
GET(Type_ub, MPI_Aint, t->ub)

CALL(Type_get_extent, (MPI_Datatype type, MPI_Aint *lb, MPI_Aint *extent))
{
    const struct type *t = type_of(type);
    if (!t)
        return no_type("MPI_Type_get_extent");
    *lb = t->lb, *extent = type_extent(t);
    return MPI_SUCCESS;
}

CALL(Type_get_true_extent, (MPI_Datatype type, MPI_Aint *lb, MPI_Aint *extent))
{
    const struct type *t = type_of(type);
    if (!t)
        return no_type("MPI_Type_get_true_extent");
    *lb = t->true_lb, *extent = t->true_ub - t->true_lb;
    return MPI_SUCCESS;
}

CALL(Type_get_extent_x, (MPI_Datatype type, MPI_Count *lb, MPI_Count *extent))
{
    return PMPI_Type_get_extent(type, lb, extent);
}

CALL(Type_get_true_extent_x, (MPI_Datatype type, MPI_Count *lb, MPI_Count *extent))
{
    return PMPI_Type_get_true_extent(type, lb, extent);
}

CALL(Type_match_size, (int kind, int size, MPI_Datatype *type))
{
    static const struct match {
        int kind, size;
        MPI_Datatype type;
    } matches[] = {{MPI_TYPECLASS_INTEGER, 1, MPI_INTEGER1},   {MPI_TYPECLASS_INTEGER, 2, MPI_INTEGER2},
                   {MPI_TYPECLASS_INTEGER, 4, MPI_INTEGER4},   {MPI_TYPECLASS_INTEGER, 8, MPI_INTEGER8},
                   {MPI_TYPECLASS_REAL, 4, MPI_REAL4},         {MPI_TYPECLASS_REAL, 8, MPI_REAL8},
                   {MPI_TYPECLASS_REAL, 16, MPI_REAL16},       {MPI_TYPECLASS_COMPLEX, 8, MPI_COMPLEX8},
                   {MPI_TYPECLASS_COMPLEX, 16, MPI_COMPLEX16}, {MPI_TYPECLASS_COMPLEX, 32, MPI_COMPLEX32}};
    for (size_t i = 0; i < sizeof matches / sizeof *matches; i++)
        if (matches[i].kind == kind && matches[i].size == size)
            return *type = matches[i].type, MPI_SUCCESS;
    return fail(NULL, CALL_Other, MPI_ERR_ARG, "MPI_Type_match_size: no datatype of this kind has %d bytes",
                size);
}

CALL(Type_get_envelope, (MPI_Datatype type, int *ints, int *addresses, int *types, int *combiner))
{
    const struct type *t = type_of(type);
    if (!t)
        return no_type("MPI_Type_get_envelope");
    *ints = t->ints, *addresses = t->addresses, *types = t->types, *combiner = t->combiner;
    return MPI_SUCCESS;
}

CALL(Type_get_contents, (MPI_Datatype type, int max_ints, int max_addresses, int max_types, int ints[],
                         MPI_Aint addresses[], MPI_Datatype types[]))
{
    const struct type *t = type_of(type);
    if (!t)
        return no_type("MPI_Type_get_contents");
    if (t->combiner == MPI_COMBINER_NAMED || max_ints < t->ints || max_addresses < t->addresses ||
        max_types < t->types)
        return fail(NULL, CALL_Other, MPI_ERR_ARG,
                    "MPI_Type_get_contents: a type of MPI's own, or too little room");
    memcpy(ints, t->int_list, (size_t)t->ints * sizeof *ints);
    memcpy(addresses, t->address_list, (size_t)t->addresses * sizeof *addresses);
    for (int i = 0; i < t->types; i++) {
        types[i] = t->type_list[i];
        type_keep(types[i]);
    }
    return MPI_SUCCESS;
}

CALL(Type_set_name, (MPI_Datatype type, const char *name))
{
    struct type *t = type_of(type);
    if (!t)
        return no_type("MPI_Type_set_name");
    free(t->name);
    t->name = strndup(name, MPI_MAX_OBJECT_NAME - 1);
    return MPI_SUCCESS;
}

/* A type of MPI's own by the name of its constant. */
static const char *own_name(MPI_Datatype type)
{
#define NAME(t)                                                                                              \
    {                                                                                                        \
        t, #t                                                                                                \
    }
    static const struct name {
        MPI_Datatype type;
        const char *name;
    } names[] = {NAME(MPI_INT),
                 NAME(MPI_DOUBLE),
                 NAME(MPI_FLOAT),
                 NAME(MPI_CHAR),
                 NAME(MPI_BYTE),
                 NAME(MPI_PACKED),
                 NAME(MPI_SHORT),
                 NAME(MPI_LONG),
                 NAME(MPI_LONG_LONG_INT),
                 NAME(MPI_UNSIGNED_SHORT),
                 NAME(MPI_UNSIGNED),
                 NAME(MPI_UNSIGNED_LONG),
                 NAME(MPI_UNSIGNED_LONG_LONG),
                 NAME(MPI_SIGNED_CHAR),
                 NAME(MPI_UNSIGNED_CHAR),
                 NAME(MPI_LONG_DOUBLE),
                 NAME(MPI_WCHAR),
                 NAME(MPI_FLOAT_INT),
                 NAME(MPI_DOUBLE_INT),
                 NAME(MPI_LONG_INT),
                 NAME(MPI_2INT),
                 NAME(MPI_SHORT_INT),
                 NAME(MPI_LONG_DOUBLE_INT),
                 NAME(MPI_LOGICAL),
                 NAME(MPI_INTEGER),
                 NAME(MPI_REAL),
                 NAME(MPI_COMPLEX),
                 NAME(MPI_DOUBLE_PRECISION),
                 NAME(MPI_DOUBLE_COMPLEX),
                 NAME(MPI_CHARACTER),
                 NAME(MPI_2REAL),
                 NAME(MPI_2DOUBLE_PRECISION),
                 NAME(MPI_2INTEGER),
                 NAME(MPI_INT8_T),
                 NAME(MPI_INT16_T),
                 NAME(MPI_INT32_T),
                 NAME(MPI_INT64_T),
                 NAME(MPI_UINT8_T),
                 NAME(MPI_UINT16_T),
                 NAME(MPI_UINT32_T),
                 NAME(MPI_UINT64_T),
                 NAME(MPI_C_BOOL),
                 NAME(MPI_C_COMPLEX),
                 NAME(MPI_C_DOUBLE_COMPLEX),
                 NAME(MPI_C_LONG_DOUBLE_COMPLEX),
                 NAME(MPI_AINT),
                 NAME(MPI_COUNT),
                 NAME(MPI_OFFSET),
                 NAME(MPI_INTEGER1),
                 NAME(MPI_INTEGER2),
                 NAME(MPI_INTEGER4),
                 NAME(MPI_INTEGER8),
                 NAME(MPI_REAL4),
                 NAME(MPI_REAL8),
                 NAME(MPI_COMPLEX8),
                 NAME(MPI_COMPLEX16),
                 NAME(MPI_REAL16),
                 NAME(MPI_INTEGER16),
                 NAME(MPI_COMPLEX32),
                 NAME(MPI_CXX_BOOL),
                 NAME(MPI_CXX_FLOAT_COMPLEX),
                 NAME(MPI_CXX_DOUBLE_COMPLEX),
                 NAME(MPI_CXX_LONG_DOUBLE_COMPLEX),
                 NAME(MPI_LOGICAL4),
                 NAME(MPI_LOGICAL8),
                 NAME(MPI_LB),
                 NAME(MPI_UB)};
#undef NAME
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (names[i].type == type)
            return names[i].name;
    return "";
}

CALL(Type_get_name, (MPI_Datatype type, char *name, int *length))
{
    const struct type *t = type_of(type);
    if (!t && type != MPI_DATATYPE_NULL)
        return no_type("MPI_Type_get_name");
    *length = snprintf(name, MPI_MAX_OBJECT_NAME, "%s",
                       !t        ? "MPI_DATATYPE_NULL"
                       : t->name ? t->name
                                 : own_name(type));
    return MPI_SUCCESS;
}

CALL(Get_address, (const void *at, MPI_Aint *address))
{
    *address = (MPI_Aint)at;
    return MPI_SUCCESS;
}
