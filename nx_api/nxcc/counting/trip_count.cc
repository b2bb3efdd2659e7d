/* trip_count.cc - see trip_count.h. */
#include "counting/trip_count.h"

namespace
{
/* A poll costs little in a loop whose trip count takes more to compute. */
const unsigned most_operations = 12;

/* The operations of an expression. Division of any kind is too many, except EXACT_DIV_EXPR, a
 * multiplication; so is a call, as of __builtin_popcount where a loop clears one bit after the other. */
unsigned operations(tree expr)
{
    if (!EXPR_P(expr))
        return 0;
    switch (TREE_CODE(expr)) {
    case TRUNC_DIV_EXPR:
    case FLOOR_DIV_EXPR:
    case CEIL_DIV_EXPR:
    case ROUND_DIV_EXPR:
    case TRUNC_MOD_EXPR:
    case FLOOR_MOD_EXPR:
    case CEIL_MOD_EXPR:
    case ROUND_MOD_EXPR:
    case CALL_EXPR:
        return most_operations + 1;
    default:
        break;
    }
    unsigned sum = 1;
    for (int i = 0; i < TREE_OPERAND_LENGTH(expr); i++)
        sum += operations(TREE_OPERAND(expr, i));
    return sum;
}

tree append_value(gimple_seq *seq, tree expr)
{
    gimple_seq more = NULL;
    tree value = force_gimple_operand(unshare_expr(expr), &more, true, NULL_TREE);
    gimple_seq_add_seq_without_update(seq, more);
    return value;
}
} // namespace

bool trip_count_is_known(class loop *loop, tree_niter_desc *n)
{
    edge exit = single_exit(loop);
    return exit && !(exit->flags & EDGE_COMPLEX) &&
           number_of_iterations_exit_assumptions(loop, exit, n, NULL) &&
           operations(n->assumptions) + operations(n->may_be_zero) + operations(n->niter) <= most_operations;
}

int64_t trip_count_constant(class loop *loop)
{
    tree_niter_desc n;
    if (!trip_count_is_known(loop, &n) || !integer_onep(n.assumptions) || !integer_zerop(n.may_be_zero) ||
        !tree_fits_shwi_p(n.niter))
        return -1;
    return tree_to_shwi(n.niter);
}

tree trip_count_append(gimple_seq *seq, class loop *loop, const tree_niter_desc &n, int64_t limit)
{
    tree type = unsigned_type_for(units_type()), most = build_int_cst(type, limit);
    tree trips = gimple_convert(seq, unsigned_type_for(TREE_TYPE(n.niter)), append_value(seq, n.niter));
    trips = gimple_convert(seq, type, trips);
    if (!integer_zerop(n.may_be_zero))
        trips = gimple_build(seq, COND_EXPR, type, append_value(seq, n.may_be_zero), build_int_cst(type, 0),
                             trips);
    widest_int bound;
    if (wi::ges_p(n.max, limit) && !(max_loop_iterations(loop, &bound) && wi::lts_p(bound, limit)))
        trips = gimple_build(seq, MIN_EXPR, type, trips, most);
    if (!integer_onep(n.assumptions))
        trips = gimple_build(seq, COND_EXPR, type, append_value(seq, n.assumptions), trips, most);
    return gimple_convert(seq, units_type(), trips);
}
