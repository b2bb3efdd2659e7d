/* type_making.c - datatypes that are made of others: blocks of them, one behind the other or at places. */
#include <stdlib.h>
#include "types.h"

struct type *type_new(void)
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

void type_add(struct type *t, int *room, const struct type *old, int count, MPI_Aint at)
{
    MPI_Aint extent = type_extent(old);
    if (count > 0)
        t->size += (size_t)count * old->size;
    if (old->runs == 1 && (MPI_Aint)old->run->bytes == extent) { /* the elements are one run */
        if (count > 0)
            add_run(t, room,
                    (struct run){at + old->run->at, (size_t)count * old->run->bytes, old->run->unit});
    } else {
        for (int i = 0; i < count; i++)
            for (int k = 0; k < old->runs; k++)
                add_run(t, room,
                        (struct run){at + i * extent + old->run[k].at, old->run[k].bytes, old->run[k].unit});
    }
    const bool marks = !old->size; /* has places of markers at most, and no data */
    if (count <= 0 || (marks && !old->has_lb && !old->has_ub))
        return;
    MPI_Aint first = at, last = at + (count - 1) * extent;
    MPI_Aint low = extent < 0 ? last : first, high = extent < 0 ? first : last;
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

MPI_Datatype type_finish(struct type *t, int combiner, bool padded)
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

void type_made_of(struct type *t, int ints, int addresses, int types)
{
    t->ints = ints, t->addresses = addresses, t->types = types;
    t->int_list = get_memory((size_t)ints * sizeof *t->int_list);
    t->address_list = get_memory((size_t)addresses * sizeof *t->address_list);
    t->type_list = get_memory((size_t)types * sizeof *t->type_list);
}

void type_made_of_type(struct type *t, int i, MPI_Datatype old)
{
    t->type_list[i] = old;
    type_keep(old);
}

static int bad_count(int call, int count)
{
    return fail(NULL, call, MPI_ERR_COUNT, "the count %d is negative", count);
}

CALL(Type_contiguous, (int count, MPI_Datatype old, MPI_Datatype *type))
{
    const struct type *o = type_of(old);
    int room = 0;
    if (!o)
        return type_missing(CALL_Type_contiguous);
    if (!type)
        return fail_answer(NULL, CALL_Type_contiguous);
    if (count < 0)
        return bad_count(CALL_Type_contiguous, count);
    struct type *t = type_new();
    type_add(t, &room, o, count, 0);
    type_made_of(t, 1, 0, 1);
    t->int_list[0] = count;
    type_made_of_type(t, 0, old);
    *type = type_finish(t, MPI_COMBINER_CONTIGUOUS, false);
    return MPI_SUCCESS;
}

static struct type *strided(int count, int length, MPI_Aint bytes, const struct type *o)
{
    struct type *t = type_new();
    int room = 0;
    for (int i = 0; i < count; i++)
        type_add(t, &room, o, length, i * bytes);
    return t;
}

CALL(Type_vector, (int count, int length, int stride, MPI_Datatype old, MPI_Datatype *type))
{
    const struct type *o = type_of(old);
    if (!o)
        return type_missing(CALL_Type_vector);
    if (!type)
        return fail_answer(NULL, CALL_Type_vector);
    if (count < 0 || length < 0)
        return bad_count(CALL_Type_vector, count < 0 ? count : length);
    struct type *t = strided(count, length, stride * type_extent(o), o);
    type_made_of(t, 3, 0, 1);
    t->int_list[0] = count, t->int_list[1] = length, t->int_list[2] = stride;
    type_made_of_type(t, 0, old);
    *type = type_finish(t, MPI_COMBINER_VECTOR, false);
    return MPI_SUCCESS;
}

CALL(Type_create_hvector, (int count, int length, MPI_Aint stride, MPI_Datatype old, MPI_Datatype *type))
{
    const struct type *o = type_of(old);
    if (!o)
        return type_missing(CALL_Type_create_hvector);
    if (!type)
        return fail_answer(NULL, CALL_Type_create_hvector);
    if (count < 0 || length < 0)
        return bad_count(CALL_Type_create_hvector, count < 0 ? count : length);
    struct type *t = strided(count, length, stride, o);
    type_made_of(t, 2, 1, 1);
    t->int_list[0] = count, t->int_list[1] = length, t->address_list[0] = stride;
    type_made_of_type(t, 0, old);
    *type = type_finish(t, MPI_COMBINER_HVECTOR, false);
    return MPI_SUCCESS;
}

/* The first negative one of the lengths of blocks; 0: there is none. */
static int negative(int count, const int lengths[])
{
    for (int i = 0; i < count; i++)
        if (lengths[i] < 0)
            return lengths[i];
    return 0;
}

/* Blocks at places: of one length if lengths is NULL; places in elements, or in bytes. */
struct places {
    int count, length;
    const int *lengths, *elements;
    const MPI_Aint *bytes;
};

static int indexed(int call, const struct places *p, MPI_Datatype old, int combiner, MPI_Datatype *type)
{
    const struct type *o = type_of(old);
    int room = 0, at = 0;
    if (!o)
        return type_missing(call);
    if (!type)
        return fail_answer(NULL, call);
    int wrong = p->count < 0 ? p->count : p->lengths ? negative(p->count, p->lengths) : p->length;
    if (wrong < 0)
        return bad_count(call, wrong);
    struct type *t = type_new();
    type_made_of(t, 1 + (p->lengths ? p->count : 1) + (p->elements ? p->count : 0),
                 p->elements ? 0 : p->count, 1);
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
        type_add(t, &room, o, p->lengths ? p->lengths[i] : p->length, place);
    }
    type_made_of_type(t, 0, old);
    *type = type_finish(t, combiner, false);
    return MPI_SUCCESS;
}

CALL(Type_indexed, (int count, const int lengths[], const int at[], MPI_Datatype old, MPI_Datatype *type))
{
    return indexed(CALL_Type_indexed, &(struct places){count, 0, lengths, at, NULL}, old,
                   MPI_COMBINER_INDEXED, type);
}

CALL(Type_create_hindexed,
     (int count, const int lengths[], const MPI_Aint at[], MPI_Datatype old, MPI_Datatype *type))
{
    return indexed(CALL_Type_create_hindexed, &(struct places){count, 0, lengths, NULL, at}, old,
                   MPI_COMBINER_HINDEXED, type);
}

CALL(Type_create_indexed_block, (int count, int length, const int at[], MPI_Datatype old, MPI_Datatype *type))
{
    return indexed(CALL_Type_create_indexed_block, &(struct places){count, length, NULL, at, NULL}, old,
                   MPI_COMBINER_INDEXED_BLOCK, type);
}

CALL(Type_create_hindexed_block,
     (int count, int length, const MPI_Aint at[], MPI_Datatype old, MPI_Datatype *type))
{
    return indexed(CALL_Type_create_hindexed_block, &(struct places){count, length, NULL, NULL, at}, old,
                   MPI_COMBINER_HINDEXED_BLOCK, type);
}

CALL(Type_create_struct,
     (int count, const int lengths[], const MPI_Aint at[], const MPI_Datatype types[], MPI_Datatype *type))
{
    int room = 0;
    int wrong = count < 0 ? count : negative(count, lengths);
    if (wrong)
        return bad_count(CALL_Type_create_struct, wrong);
    for (int i = 0; i < count; i++)
        if (!type_of(types[i]))
            return type_missing(CALL_Type_create_struct);
    if (!type)
        return fail_answer(NULL, CALL_Type_create_struct);
    struct type *t = type_new();
    type_made_of(t, 1 + count, count, count);
    t->int_list[0] = count;
    for (int i = 0; i < count; i++) {
        t->int_list[1 + i] = lengths[i], t->address_list[i] = at[i];
        type_made_of_type(t, i, types[i]);
        type_add(t, &room, type_of(types[i]), lengths[i], at[i]);
    }
    *type = type_finish(t, MPI_COMBINER_STRUCT, true);
    return MPI_SUCCESS;
}

CALL(Type_create_resized, (MPI_Datatype old, MPI_Aint lb, MPI_Aint extent, MPI_Datatype *type))
{
    const struct type *o = type_of(old);
    int room = 0;
    if (!o)
        return type_missing(CALL_Type_create_resized);
    if (!type)
        return fail_answer(NULL, CALL_Type_create_resized);
    struct type *t = type_new();
    type_add(t, &room, o, 1, 0);
    t->lb = lb, t->ub = lb + extent, t->has_lb = t->has_ub = true;
    type_made_of(t, 0, 2, 1);
    t->address_list[0] = lb, t->address_list[1] = extent;
    type_made_of_type(t, 0, old);
    *type = type_finish(t, MPI_COMBINER_RESIZED, false);
    return MPI_SUCCESS;
}

CALL(Type_dup, (MPI_Datatype old, MPI_Datatype *type))
{
    struct type *o = type_of(old);
    int room = 0, code;
    if (!o)
        return type_missing(CALL_Type_dup);
    if (!type)
        return fail_answer(NULL, CALL_Type_dup);
    struct type *t = type_new();
    type_add(t, &room, o, 1, 0);
    t->lb = o->lb, t->ub = o->ub, t->has_lb = o->has_lb, t->has_ub = o->has_ub;
    type_made_of(t, 0, 0, 1);
    type_made_of_type(t, 0, old);
    *type = type_finish(t, MPI_COMBINER_DUP, false);
    t->committed = o->committed;
    code = type_copy_attributes(o, t);
    if (!code)
        return MPI_SUCCESS;
    type_leave(*type);
    *type = MPI_DATATYPE_NULL;
    return fail(NULL, CALL_Type_dup, code, "an attribute's copy function says no");
}
