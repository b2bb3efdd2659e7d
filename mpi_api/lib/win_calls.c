/* win_calls.c - the calls that access the memory of other ranks. */
#include <stdlib.h>
#include "wins.h"

/* --- checks --- */

/* The one datatype of MPI's own that a type is made of; MPI_DATATYPE_NULL: it is made of several. */
static MPI_Datatype element_of(MPI_Datatype handle)
{
    if (type_basic(handle))
        return handle;
    const struct type *t = type_of(handle);
    MPI_Datatype element = t->types ? element_of(t->type_list[0]) : MPI_DATATYPE_NULL;
    for (int i = 1; i < t->types; i++)
        if (element_of(t->type_list[i]) != element)
            return MPI_DATATYPE_NULL;
    return element;
}

static const char *why_not_compared(MPI_Datatype type)
{
    const struct basic *b = type_basic(type);
    bool may = b && (b->class == WHOLE || b->class == NATURAL || b->class == LOGICAL || b->class == BITS);
    return may ? NULL : "what is compared is an integer, a logical or a byte";
}

/* Elements that are combined are of one type of MPI's own. */
static const char *why_not(struct access *a)
{
    if (a->compare)
        return why_not_compared(a->their_type);
    if (a->op == MPI_REPLACE || a->op == MPI_NO_OP)
        return NULL;
    a->element = element_of(a->their_type);
    if (a->element == MPI_DATATYPE_NULL || element_of(a->type) != a->element)
        return "the elements are not all of one datatype of MPI's own";
    const struct basic *b = type_basic(a->element);
    a->whole = b->class == PAIR && size_of(a->element) < b->bytes;
    return op_is_own(a->op) ? op_refuses(a->op, a->element) : "the operation is not one of MPI's own";
}

static bool is_outside(const struct win *w, const struct access *a)
{
    const struct type *t = type_of(a->their_type);
    const struct remote *r = &w->remote[a->rank];
    MPI_Aint at = a->place * r->unit, last = at + (a->their_count - 1) * type_extent(t);
    return a->their_count > 0 && (at + t->true_lb < 0 || last + t->true_ub > r->size);
}

static int check_elements(struct win *w, struct access *a)
{
    size_t theirs = (size_t)a->their_count * size_of(a->their_type);
    if (a->count < 0 || a->room < 0 || a->their_count < 0)
        return fail_win(w, a->call, MPI_ERR_COUNT, "a count is negative");
    if ((a->sends && (size_t)a->count * size_of(a->type) != theirs) ||
        (a->fetches && (size_t)a->room * size_of(a->as) != theirs))
        return fail_win(w, a->call, MPI_ERR_ARG, "there are %zu bytes at the target, and others here",
                        theirs);
    return MPI_SUCCESS;
}

static int check(struct win *w, struct access *a)
{
    if (a->rank < 0 || a->rank >= w->comm->local->size)
        return fail_win(w, a->call, MPI_ERR_RANK, "there is no rank %d in the window (ranks are 0 to %d)",
                        a->rank, w->comm->local->size - 1);
    if ((a->sends && !type_is_valid(a->type)) || (a->fetches && !type_is_valid(a->as)) ||
        !type_is_valid(a->their_type))
        return fail_win(w, a->call, MPI_ERR_TYPE, "a datatype is null, freed, or not committed");
    int code = check_elements(w, a);
    if (code)
        return code;
    const char *why = access_messages(a) ? why_not(a) : NULL;
    if (why)
        return fail_win(w, a->call, MPI_ERR_OP, "%s", why);
    if (w->flavor != MPI_WIN_FLAVOR_DYNAMIC && is_outside(w, a))
        return fail_win(w, a->call, MPI_ERR_RMA_RANGE, "rank %d's window has %ld bytes in units of %d",
                        a->rank, (long)w->remote[a->rank].size, w->remote[a->rank].unit);
    return MPI_SUCCESS;
}

/* --- what happens --- */

static int no_epoch(struct win *w, const struct access *a)
{
    return fail_win(w, a->call, MPI_ERR_RMA_SYNC,
                    "rank %d is accessed before MPI_Win_fence, MPI_Win_start or MPI_Win_lock", a->rank);
}

static int begin(MPI_Win win, struct access *a)
{
    struct win *w = win_of(win);
    if (!w)
        return fail_no_win(a->call);
    if (a->rank == MPI_PROC_NULL)
        return MPI_SUCCESS;
    int code = check(w, a);
    if (code)
        return code;
    if (passive_may(w, a->rank))
        passive_send(w, a);
    else if (active_may(w, a->rank))
        active_keep(w, a);
    else
        return no_epoch(w, a);
    return MPI_SUCCESS;
}

/* Those with requests are done here when the call returns. */
static int begin_and_wait(MPI_Win win, struct access *a, MPI_Request *request)
{
    struct win *w = win_of(win);
    if (w && a->rank >= 0 && a->rank < w->comm->local->size && !passive_may(w, a->rank))
        return fail_win(w, a->call, MPI_ERR_RMA_SYNC,
                        "rank %d is accessed with a request before MPI_Win_lock", a->rank);
    int code = begin(win, a);
    if (code)
        return code;
    access_wait(w, a->call, a->rank);
    struct request *r = request_new();
    r->what = MOVES, r->active = true;
    r->type = MPI_BYTE;
    status_empty(&r->status);
    *request = HANDLE(MPI_Request, r);
    return MPI_SUCCESS;
}

/* --- the calls --- */

#define HERE const void *buf, int count, MPI_Datatype type
#define INTO void *into, int room, MPI_Datatype as
#define THERE int rank, MPI_Aint place, int their_count, MPI_Datatype their_type
#define SENDS .sends = true, .buf = buf, .count = count, .type = type
#define FETCHES .fetches = true, .into = into, .room = room, .as = as
#define TARGET .rank = rank, .place = place, .their_count = their_count, .their_type = their_type
#define LIST(...) __VA_ARGS__

/* The parameters, in parentheses; the members of the access. */
#define ACCESS(name, parameters, ...)                                                                        \
    CALL(name, (LIST parameters, MPI_Win win))                                                               \
    {                                                                                                        \
        struct access a = {.call = CALL_##name, __VA_ARGS__};                                                \
        return begin(win, &a);                                                                               \
    }
#define ACCESS_AND_REQUEST(name, rname, parameters, ...)                                                     \
    ACCESS(name, parameters, __VA_ARGS__)                                                                    \
    CALL(rname, (LIST parameters, MPI_Win win, MPI_Request * request))                                       \
    {                                                                                                        \
        struct access a = {.call = CALL_##rname, __VA_ARGS__};                                               \
        return begin_and_wait(win, &a, request);                                                             \
    }
ACCESS_AND_REQUEST(Put, Rput, (HERE, THERE), SENDS, TARGET, .op = MPI_REPLACE)
ACCESS_AND_REQUEST(Get, Rget, (INTO, THERE), FETCHES, TARGET, .op = MPI_NO_OP)
ACCESS_AND_REQUEST(Accumulate, Raccumulate, (HERE, THERE, MPI_Op op), SENDS, TARGET, .op = op)

/* With MPI_NO_OP nothing is sent. */
#define SENDS_UNLESS_GET .sends = op != MPI_NO_OP, .buf = buf, .count = count, .type = type
ACCESS_AND_REQUEST(Get_accumulate, Rget_accumulate, (HERE, INTO, THERE, MPI_Op op), SENDS_UNLESS_GET, FETCHES,
                   TARGET, .op = op)

#define ONE .count = 1, .room = 1, .their_count = 1, .type = type, .as = type, .their_type = type
ACCESS(Fetch_and_op, (const void *buf, void *into, MPI_Datatype type, int rank, MPI_Aint place, MPI_Op op),
       .sends = op != MPI_NO_OP, .fetches = true, .buf = buf, .into = into, .rank = rank, .place = place,
       .op = op, ONE)
ACCESS(Compare_and_swap,
       (const void *buf, const void *compare, void *into, MPI_Datatype type, int rank, MPI_Aint place),
       .sends = true, .fetches = true, .buf = buf, .compare = compare, .into = into, .rank = rank,
       .place = place, .op = MPI_REPLACE, ONE)
