/* coll_reduce.c - reductions, to one rank and to all, and over the ranks before one.
 *
 * Algorithms and their limits: Thakur, Rabenseifner and Gropp (2005), as in coll_one.c. An operation that
 * does not commute gets its operands in the order of the ranks. */
#include <stdlib.h>
#include <string.h>
#include "coll.h"

/* --- buffers for elements of any type: as long as they are in the program's --- */

struct operand operand_new(int count, MPI_Datatype type)
{
    const struct type *t = type_of(type);
    MPI_Aint low = t->true_lb, bytes = t->true_ub - t->true_lb;
    if (count > 1)
        bytes += (count - 1) * type_extent(t);
    struct operand x = {.memory = get_memory((size_t)bytes + 16)};
    x.at = x.memory - low;
    return x;
}

void operand_free(struct operand x)
{
    free(x.memory);
}

static void swap(struct operand *x, struct operand *y)
{
    struct operand z = *x;
    *x = *y, *y = z;
}

/* A reduction under way: own so far, and what comes. */
struct sum {
    const struct coll *o;
    struct operand own, other;
    int count;
    MPI_Datatype t;
    MPI_Op op;
};

static struct sum sum_begin(const struct coll *o, const void *buf, int count, MPI_Datatype t, MPI_Op op)
{
    struct sum s = {o, operand_new(count, t), operand_new(count, t), count, t, op};
    type_copy(buf, count, t, s.own.at, count, t);
    return s;
}

static void sum_end(struct sum *s)
{
    operand_free(s->own);
    operand_free(s->other);
}

/* The other operand is there; own = other op own, or own op other. */
static void add(struct sum *s, bool other_is_left)
{
    if (other_is_left) {
        op_apply(s->op, s->other.at, s->own.at, s->count, s->t);
        return;
    }
    op_apply(s->op, s->own.at, s->other.at, s->count, s->t);
    swap(&s->own, &s->other);
}

static void send_own(const struct sum *s, int to)
{
    coll_send(s->o, s->own.at, s->count, s->t, to);
}

static int receive_other(struct sum *s, int from)
{
    return coll_receive(s->o, s->other.at, s->count, s->t, from);
}

static int exchange(struct sum *s, int peer)
{
    return coll_exchange(s->o, s->own.at, s->count, s->t, peer, s->other.at, s->count, s->t, peer);
}

/* --- to one: a binomial tree --- */

static int reduce_tree(struct sum *s, int root)
{
    int size = s->o->size, rel = (s->o->rank - root + size) % size, code = MPI_SUCCESS;
    for (int mask = 1; mask < size && !code; mask *= 2) {
        if (rel & mask) {
            send_own(s, (rel - mask + root) % size);
            break;
        }
        if (rel + mask < size) {
            code = receive_other(s, (rel + mask + root) % size);
            if (!code)
                add(s, false);
        }
    }
    return code;
}

int coll_reduce(const struct coll *o, const void *buf, void *into, int count, MPI_Datatype t, MPI_Op op,
                int root)
{
    struct sum s = sum_begin(o, buf, count, t, op);
    int first = op_commutes(op) ? root : 0, rank = o->rank;
    int code = reduce_tree(&s, first);
    if (!code && first != root && rank == first)
        send_own(&s, root);
    if (!code && first != root && rank == root)
        code = coll_receive(o, into, count, t, first);
    else if (!code && rank == root)
        type_copy(s.own.at, count, t, into, count, t);
    sum_end(&s);
    return code;
}

/* --- to all --- */

/* Short ones: recursive doubling. Long ones, of MPI's own types: each rank reduces a part, then all gather
 * the parts (Rabenseifner). The ranks beyond a power of two hand theirs to a neighbour first. */
enum { SHORT_ALLREDUCE = 2048 };

struct fold {
    int power;  /* so many take part */
    int rest;   /* the first 2 rest ranks are pairs, of which the second takes part */
    int number; /* among those that take part; -1: does not */
};

static struct fold fold_of(const struct coll *o)
{
    struct fold f = {1, 0, 0};
    int rank = o->rank;
    while (f.power <= o->size / 2)
        f.power *= 2;
    f.rest = o->size - f.power;
    f.number = rank >= 2 * f.rest ? rank - f.rest : rank % 2 ? rank / 2 : -1;
    return f;
}

static int fold_rank(const struct fold *f, int number)
{
    return number < f->rest ? 2 * number + 1 : number + f->rest;
}

/* Those that do not take part hand over what they have. */
static int fold_in(struct sum *s, const struct fold *f)
{
    int rank = s->o->rank, code = MPI_SUCCESS;
    if (f->number < 0)
        send_own(s, rank + 1);
    else if (rank < 2 * f->rest && !(code = receive_other(s, rank - 1)))
        add(s, true);
    return code;
}

/* And get the result. */
static int fold_out(struct sum *s, const struct fold *f)
{
    int rank = s->o->rank;
    if (f->number < 0)
        return coll_receive(s->o, s->own.at, s->count, s->t, rank + 1);
    if (rank < 2 * f->rest)
        send_own(s, rank - 1);
    return MPI_SUCCESS;
}

static int doubling(struct sum *s, const struct fold *f)
{
    int code = MPI_SUCCESS;
    for (int mask = 1; mask < f->power && !code; mask *= 2) {
        int peer = fold_rank(f, f->number ^ mask);
        code = exchange(s, peer);
        if (!code)
            add(s, peer < s->o->rank);
    }
    return code;
}

static int part_at(int count, int parts, int i)
{
    return (int)((long)count * i / parts);
}

/* Halves what the rank reduces, step by step, down to one part; then doubles what it has of the result. */
static int halving(struct sum *s, const struct fold *f)
{
    int first = 0, last = f->power, code = MPI_SUCCESS;
    for (int mask = f->power / 2; mask && !code; mask /= 2) {
        int peer = fold_rank(f, f->number ^ mask), middle = first + mask;
        bool low = !(f->number & mask);
        int give = low ? middle : first, give_end = low ? last : middle;
        int keep = low ? first : middle, keep_end = low ? middle : last;
        int at = part_at(s->count, f->power, give), n = part_at(s->count, f->power, give_end) - at;
        int own = part_at(s->count, f->power, keep), m = part_at(s->count, f->power, keep_end) - own;
        code = coll_exchange(s->o, element(s->own.at, at, s->t), n, s->t, peer,
                             element(s->other.at, own, s->t), m, s->t, peer);
        if (!code)
            op_apply(s->op, element(s->other.at, own, s->t), element(s->own.at, own, s->t), m, s->t);
        first = keep, last = keep_end;
    }
    for (int mask = 1; mask < f->power && !code; mask *= 2) {
        int peer = fold_rank(f, f->number ^ mask);
        int have = f->number & -mask, theirs = have ^ mask;
        int at = part_at(s->count, f->power, have), n = part_at(s->count, f->power, have + mask) - at;
        int in = part_at(s->count, f->power, theirs), m = part_at(s->count, f->power, theirs + mask) - in;
        code = coll_exchange(s->o, element(s->own.at, at, s->t), n, s->t, peer, element(s->own.at, in, s->t),
                             m, s->t, peer);
    }
    return code;
}

int coll_allreduce(const struct coll *o, const void *buf, void *into, int count, MPI_Datatype t, MPI_Op op)
{
    if (mpi_of_1995)
        return old_allreduce(o, buf, into, count, t, op);
    struct sum s = sum_begin(o, buf, count, t, op);
    struct fold f = fold_of(o);
    bool brief = (size_t)count * size_of(t) <= SHORT_ALLREDUCE || !op_is_own(op) || count < f.power ||
                 !op_commutes(op);
    int code = fold_in(&s, &f);
    if (!code && f.number >= 0)
        code = brief ? doubling(&s, &f) : halving(&s, &f);
    if (!code)
        code = fold_out(&s, &f);
    if (!code)
        type_copy(s.own.at, count, t, into, count, t);
    sum_end(&s);
    return code;
}

/* --- the calls --- */

/* gets: the rank has the result. */
static int check_reduction(const struct args *a, int count, bool gets)
{
    int code = coll_check(&a->o, count, a->type);
    const char *refuses = code ? NULL : op_refuses(a->op, a->type);
    if (refuses)
        return fail(a->o.c, a->o.call, MPI_ERR_OP, "%s", refuses);
    return code || !gets ? code : coll_check_apart(a);
}

/* What the rank brings. */
static const void *operand_of(const struct args *a)
{
    return a->buf == MPI_IN_PLACE ? a->into : a->buf;
}

static int check_reduce(struct args *a)
{
    int code = coll_check_root(&a->o, a->root);
    return code || a->root == MPI_PROC_NULL ? code : check_reduction(a, a->count, a->o.rank == a->root);
}

static int reduce(struct args *a)
{
    if (a->o.c->remote)
        return inter_reduce(a);
    return coll_reduce(&a->o, operand_of(a), a->into, a->count, a->type, a->op, a->root);
}

static int check_allreduce(struct args *a)
{
    return check_reduction(a, a->count, true);
}

static int allreduce(struct args *a)
{
    if (a->o.c->remote)
        return inter_allreduce(a);
    return coll_allreduce(&a->o, operand_of(a), a->into, a->count, a->type, a->op);
}

#define OPERANDS const void *buf, void *into, int count, MPI_Datatype type, MPI_Op op
#define GIVEN .buf = buf, .into = into, .count = count, .type = type, .op = op
COLLECTIVE(Reduce, Ireduce, reduce, (OPERANDS, int root), GIVEN, .root = root)
COLLECTIVE(Allreduce, Iallreduce, allreduce, (OPERANDS), GIVEN)

/* Reduced to the first rank, and scattered from there. */
static int reduce_and_scatter(const struct coll *o, const void *buf, void *into, const int counts[],
                              const int at[], int total, MPI_Datatype t, MPI_Op op)
{
    struct operand all = operand_new(total, t);
    int code = coll_reduce(o, buf, all.at, total, t, op, 0);
    if (!code)
        code = coll_scatterv(o, all.at, counts, at, t, into, counts[o->rank], t, 0);
    operand_free(all);
    return code;
}

static int check_reduce_scatter(struct args *a)
{
    int code = check_reduction(a, 0, true);
    for (int i = 0; i < a->o.c->local->size && !code; i++)
        code = coll_check(&a->o, a->counts[i], a->type);
    return code;
}

static int reduce_scatter(struct args *a)
{
    if (a->o.c->remote)
        return inter_reduce_scatter(a);
    int total = 0, *at = get_memory((size_t)a->o.size * sizeof *at);
    for (int i = 0; i < a->o.size; i++) {
        at[i] = total;
        total += a->counts[i];
    }
    int code = reduce_and_scatter(&a->o, operand_of(a), a->into, a->counts, at, total, a->type, a->op);
    free(at);
    return code;
}

static int check_reduce_scatter_block(struct args *a)
{
    return check_reduction(a, a->count, true);
}

static int reduce_scatter_block(struct args *a)
{
    int size = a->o.c->local->size, *counts = get_memory((size_t)size * sizeof *counts);
    for (int i = 0; i < size; i++)
        counts[i] = a->count;
    struct args b = *a;
    b.counts = counts;
    int code = reduce_scatter(&b);
    free(counts);
    return code;
}

int coll_sum_for_each(const struct coll *o, const int counts[], int *own)
{
    struct args a = {.o = *o, .buf = counts, .into = own, .count = 1, .type = MPI_INT, .op = MPI_SUM};
    return reduce_scatter_block(&a);
}

COLLECTIVE(Reduce_scatter, Ireduce_scatter, reduce_scatter,
           (const void *buf, void *into, const int counts[], MPI_Datatype type, MPI_Op op), .buf = buf,
           .into = into, .counts = counts, .type = type, .op = op)
COLLECTIVE(Reduce_scatter_block, Ireduce_scatter_block, reduce_scatter_block, (OPERANDS), GIVEN)

/* In step k a rank gets the sum of the 2^k ranks before the 2^k it has; `before`: of the ranks before it. */
static int scan(const struct coll *o, const void *buf, void *into, int count, MPI_Datatype t, MPI_Op op,
                bool inclusive)
{
    struct sum s = sum_begin(o, buf, count, t, op);
    struct operand before = operand_new(count, t), keep = operand_new(count, t);
    int size = o->size, rank = o->rank, code = MPI_SUCCESS;
    bool any = false;
    for (int mask = 1; mask < size && !code; mask *= 2) {
        if (rank + mask < size)
            send_own(&s, rank + mask);
        if (rank - mask < 0)
            continue;
        code = receive_other(&s, rank - mask);
        if (code)
            break;
        type_copy(s.other.at, count, t, keep.at, count, t);
        if (any)
            op_apply(op, keep.at, before.at, count, t);
        else
            type_copy(keep.at, count, t, before.at, count, t);
        any = true;
        add(&s, true);
    }
    if (!code && inclusive)
        type_copy(s.own.at, count, t, into, count, t);
    else if (!code && any)
        type_copy(before.at, count, t, into, count, t);
    operand_free(before);
    operand_free(keep);
    sum_end(&s);
    return code;
}

static int check_prefix(struct args *a)
{
    if (a->o.c->remote)
        return fail_groups(a->o.c, a->o.call);
    return check_reduction(a, a->count, true);
}
#define check_inclusive check_prefix
#define check_exclusive check_prefix

static int inclusive(struct args *a)
{
    if (mpi_of_1995)
        return old_scan(&a->o, operand_of(a), a->into, a->count, a->type, a->op);
    return scan(&a->o, operand_of(a), a->into, a->count, a->type, a->op, true);
}

static int exclusive(struct args *a)
{
    return scan(&a->o, operand_of(a), a->into, a->count, a->type, a->op, false);
}

COLLECTIVE(Scan, Iscan, inclusive, (OPERANDS), GIVEN)
COLLECTIVE(Exscan, Iexscan, exclusive, (OPERANDS), GIVEN)
