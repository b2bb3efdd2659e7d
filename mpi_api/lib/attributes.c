/* attributes.c - what programs attach to communicators and datatypes, by keys. */
#include <stdlib.h>
#include <string.h>
#include "lib.h"
#include "nx.h"

/* C attaches pointers, Fortran numbers: C gets the address of one that Fortran has attached, and Fortran the
 * address that C has (MPI 4.0, 19.3.7). */
struct attribute {
    struct attribute *next;
    int key;
    bool is_number;
    void *value; /* a number, as wide as an address: of little-endian machines an INTEGER, too */
};

static void *value_of(struct attribute *a, bool as_number)
{
    return a->is_number && !as_number ? (void *)&a->value : a->value;
}

/* The functions of communicators and of datatypes differ in their first parameter only: a handle. */
typedef int copy_function(void *handle, int key, void *extra, void *in, void *out, int *flag);
typedef int delete_function(void *handle, int key, void *value, void *extra);

struct key {
    copy_function *copy;
    delete_function *drop;
    void *extra;
    bool takes_numbers; /* the functions are Fortran's */
    int users;          /* attributes, and 1 until it is freed; 0: none */
    bool freed;
};

enum { FIRST_KEY = 1000 };
static struct key *keys;
static int key_count;

static struct key *key_of(int key)
{
    struct key *k = key >= FIRST_KEY && key < FIRST_KEY + key_count ? &keys[key - FIRST_KEY] : NULL;
    return k && k->users ? k : NULL;
}

int attribute_key(void *copy, void *drop, int *key, void *extra, bool takes_numbers)
{
    keys = realloc(keys, (size_t)(key_count + 1) * sizeof *keys);
    keys[key_count] =
        (struct key){(copy_function *)copy, (delete_function *)drop, extra, takes_numbers, 1, false};
    *key = FIRST_KEY + key_count++;
    return MPI_SUCCESS;
}

int attribute_key_free(int call, int *key)
{
    struct key *k = key_of(*key);
    if (!k)
        return fail(NULL, call, MPI_ERR_KEYVAL, "%s", attribute_why(MPI_ERR_KEYVAL));
    if (!k->freed)
        k->users--; /* else only attributes keep it */
    k->freed = true;
    *key = MPI_KEYVAL_INVALID;
    return MPI_SUCCESS;
}

static struct attribute **find(struct attribute **list, int key)
{
    while (*list && (*list)->key != key)
        list = &(*list)->next;
    return list;
}

/* Ends an attribute, unless the key's function, which may change the list, says no. */
static int delete_one(void *handle, struct attribute **list, int key)
{
    struct attribute *a = *find(list, key);
    struct key *k = key_of(key);
    int code = MPI_SUCCESS;
    if (a && k && k->drop)
        code = k->drop(handle, key, value_of(a, k->takes_numbers), k->extra);
    struct attribute **link = find(list, key);
    if (code || !*link)
        return code;
    a = *link;
    *link = a->next;
    keys[key - FIRST_KEY].users--;
    free(a);
    return MPI_SUCCESS;
}

/* The last set goes first. */
int attribute_delete_all(void *handle, struct attribute **list)
{
    while (*list) {
        int code = delete_one(handle, list, (*list)->key);
        if (code)
            return code;
    }
    return MPI_SUCCESS;
}

const char *attribute_why(int code)
{
    return code == MPI_ERR_KEYVAL ? "the attribute key is none, or has been freed"
                                  : "an attribute's delete function says no";
}

int attribute_delete(void *handle, struct attribute **list, int key)
{
    return key_of(key) ? delete_one(handle, list, key) : MPI_ERR_KEYVAL;
}

int attribute_set(void *handle, struct attribute **list, int key, void *value)
{
    if (!key_of(key))
        return MPI_ERR_KEYVAL;
    int code = delete_one(handle, list, key);
    if (code)
        return code;
    struct attribute *a = get_memory(sizeof *a);
    *a = (struct attribute){*list, key, false, value};
    *list = a;
    key_of(key)->users++;
    return MPI_SUCCESS;
}

int attribute_get(struct attribute **list, int key, void *value, int *flag)
{
    if (!key_of(key))
        return MPI_ERR_KEYVAL;
    struct attribute *a = *find(list, key);
    *flag = a != NULL;
    if (a)
        memcpy(value, &(void *){value_of(a, false)}, sizeof a->value);
    return MPI_SUCCESS;
}

void attribute_last_is_number(struct attribute *list)
{
    list->is_number = true;
}

MPI_Aint attribute_number(const struct attribute *list, const void *value)
{
    for (; list; list = list->next)
        if (list->is_number && value == &list->value)
            return (MPI_Aint)list->value;
    return (MPI_Aint)value;
}

/* --- communicators --- */

static void *handle_of(const struct comm *c)
{
    return c == &comm_world  ? (void *)MPI_COMM_WORLD
           : c == &comm_self ? (void *)MPI_COMM_SELF
                             : (void *)HANDLE(MPI_Comm, c);
}

int comm_delete_attributes(struct comm *c)
{
    return attribute_delete_all(handle_of(c), &c->attributes);
}

/* Oldest first, so that the copy has them in the same order. */
static int copy_from(struct attribute *a, void *from, struct attribute **to)
{
    if (!a)
        return MPI_SUCCESS;
    int code = copy_from(a->next, from, to), flag = 0;
    struct key *k = key_of(a->key);
    struct attribute made = {.key = a->key};
    if (code || !k || !k->copy)
        return code;
    if (k->copy == (copy_function *)MPI_COMM_DUP_FN)
        made = *a, flag = true;
    else {
        made.is_number = k->takes_numbers;
        code = k->copy(from, a->key, k->extra, value_of(a, k->takes_numbers), &made.value, &flag);
    }
    if (code || !flag)
        return code;
    struct attribute *copy = get_memory(sizeof *copy);
    *copy = made;
    copy->next = *to;
    *to = copy;
    key_of(a->key)->users++;
    return MPI_SUCCESS;
}

int comm_copy_attributes(struct comm *from, struct comm *to)
{
    return copy_from(from->attributes, handle_of(from), &to->attributes);
}

CALL(Comm_create_keyval,
     (MPI_Comm_copy_attr_function * copy, MPI_Comm_delete_attr_function *delete, int *keyval, void *extra))
{
    return attribute_key((void *)copy, (void *)delete, keyval, extra, false);
}

CALL(Comm_free_keyval, (int *keyval))
{
    return attribute_key_free(CALL_Comm_free_keyval, keyval);
}

static int comm_told(struct comm *c, int call, int code)
{
    return code ? fail(c, call, code, "%s", attribute_why(code)) : MPI_SUCCESS;
}

CALL(Comm_set_attr, (MPI_Comm comm, int keyval, void *value))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Comm_set_attr);
    return comm_told(c, CALL_Comm_set_attr, attribute_set(comm, &c->attributes, keyval, value));
}

/* Those that are there from the beginning: pointers to numbers. */
static const int *own_attribute(int key)
{
    static int tag_ub = 999999999, host = MPI_PROC_NULL, io = MPI_ANY_SOURCE, global = 1, size, code, program;
    size = (int)numnodes(), code = error_last_code();
    switch (key) {
    case MPI_TAG_UB:
        return &tag_ub;
    case MPI_HOST:
        return &host;
    case MPI_IO:
        return &io;
    case MPI_WTIME_IS_GLOBAL:
        return &global;
    case MPI_UNIVERSE_SIZE:
        return &size;
    case MPI_LASTUSEDCODE:
        return &code;
    case MPI_APPNUM:
        program = (int)nxm_number(NXM_PROGRAM);
        return &program;
    default:
        return NULL;
    }
}

CALL(Comm_get_attr, (MPI_Comm comm, int keyval, void *value, int *flag))
{
    struct comm *c = comm_of(comm);
    const int *own = own_attribute(keyval);
    if (!c)
        return fail_comm(CALL_Comm_get_attr);
    if (!own)
        return comm_told(c, CALL_Comm_get_attr, attribute_get(&c->attributes, keyval, value, flag));
    memcpy(value, &own, sizeof own);
    *flag = true;
    return MPI_SUCCESS;
}

CALL(Comm_delete_attr, (MPI_Comm comm, int keyval))
{
    struct comm *c = comm_of(comm);
    if (!c)
        return fail_comm(CALL_Comm_delete_attr);
    return comm_told(c, CALL_Comm_delete_attr, attribute_delete(comm, &c->attributes, keyval));
}

/* --- datatypes --- */

int type_copy_attributes(struct type *from, struct type *to)
{
    return copy_from(from->attributes, (void *)HANDLE(MPI_Datatype, from), &to->attributes);
}

int type_delete_attributes(struct type *t)
{
    return attribute_delete_all((void *)HANDLE(MPI_Datatype, t), &t->attributes);
}

CALL(Type_create_keyval,
     (MPI_Type_copy_attr_function * copy, MPI_Type_delete_attr_function *delete, int *keyval, void *extra))
{
    return attribute_key((void *)copy, (void *)delete, keyval, extra, false);
}

CALL(Type_free_keyval, (int *keyval))
{
    return attribute_key_free(CALL_Type_free_keyval, keyval);
}

static int type_told(int call, int code)
{
    return code ? fail(NULL, call, code, "%s", attribute_why(code)) : MPI_SUCCESS;
}

CALL(Type_set_attr, (MPI_Datatype type, int keyval, void *value))
{
    struct type *t = type_of(type);
    if (!t)
        return type_missing(CALL_Type_set_attr);
    return type_told(CALL_Type_set_attr, attribute_set(type, &t->attributes, keyval, value));
}

CALL(Type_get_attr, (MPI_Datatype type, int keyval, void *value, int *flag))
{
    struct type *t = type_of(type);
    if (!t)
        return type_missing(CALL_Type_get_attr);
    return type_told(CALL_Type_get_attr, attribute_get(&t->attributes, keyval, value, flag));
}

CALL(Type_delete_attr, (MPI_Datatype type, int keyval))
{
    struct type *t = type_of(type);
    if (!t)
        return type_missing(CALL_Type_delete_attr);
    return type_told(CALL_Type_delete_attr, attribute_delete(type, &t->attributes, keyval));
}
