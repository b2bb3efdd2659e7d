/* datatypes.c - MPI's own datatypes, and the life of all. Each is a list of runs of bytes, in the order of
 * its type map, and two bounds. */
#include <stdlib.h>
#include "types.h"

/* --- MPI's own --- */

#define AT(handle) [(handle)-FIRST_BASIC]
READ_OFTEN struct basic basic_types[BASICS] = {
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
    AT(0x225) = {32, COMPLEX, 0}, AT(0x239) = {1, LOGICAL, 0},  AT(0x2e1) = {16, WHOLE, 0},
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

bool type_made_is_valid(MPI_Datatype handle)
{
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

/* --- their life --- */

int type_missing(int call)
{
    return fail(NULL, call, MPI_ERR_TYPE, "the datatype is null, or freed");
}

CALL(Type_commit, (MPI_Datatype * type))
{
    struct type *t = type_of(*type);
    if (!t)
        return type_missing(CALL_Type_commit);
    t->committed = true;
    return MPI_SUCCESS;
}

/* Of those that are not MPI's own. */
void type_made_keep(MPI_Datatype handle)
{
    struct type *t = object_of(handle, TYPE);
    if (t)
        t->object.users++;
}

void type_made_leave(MPI_Datatype handle)
{
    struct type *t = object_of(handle, TYPE);
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
        return type_basic(*type) ? fail(NULL, CALL_Type_free, MPI_ERR_TYPE, "one of MPI's own types")
                                 : type_missing(CALL_Type_free);
    int code = type_delete_attributes(t);
    if (code)
        return fail(NULL, CALL_Type_free, code, "an attribute's delete function says no");
    type_leave(*type);
    *type = MPI_DATATYPE_NULL;
    return MPI_SUCCESS;
}
