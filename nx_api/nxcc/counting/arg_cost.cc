/* arg_cost.cc - see arg_cost.h. */
#include "counting/arg_cost.h"

/* Appends the number of elements of a Fortran array, given by its descriptor: a call of
 * nx_api/libgfortran/elements.c. */
static tree append_elements(gimple_seq *seq, tree array)
{
    tree count =
        build_fn_decl("nx_elements", build_function_type_list(units_type(), ptr_type_node, NULL_TREE));
    gcall *call = gimple_build_call(count, 1, array);
    tree value = make_ssa_name(units_type(), call);
    gimple_call_set_lhs(call, value);
    gimple_seq_add_stmt_without_update(seq, call);
    return value;
}

/* Appends value, or 0 if value is too large for a count. Unsigned: also if it is negative. */
static tree append_count(gimple_seq *seq, tree value)
{
    tree most = build_int_cst(TREE_TYPE(value), HOST_WIDE_INT_1 << 32); /* its square is 0 again */
    tree fits = gimple_build(seq, LE_EXPR, boolean_type_node, value, most);
    return gimple_build(seq, COND_EXPR, TREE_TYPE(value), fits, value, build_zero_cst(TREE_TYPE(value)));
}

/* Appends the price of so many bytes, which depends on the data cache: a call of runtime.c. */
static tree append_move(gimple_seq *seq, tree bytes, int64_t near, int64_t far)
{
    tree units = units_type();
    tree move = build_fn_decl("nxc_move", build_function_type_list(units, units, units, units, NULL_TREE));
    gcall *call = gimple_build_call(move, 3, bytes, units_constant(near), units_constant(far));
    tree value = make_ssa_name(units, call);
    gimple_call_set_lhs(call, value);
    gimple_seq_add_stmt_without_update(seq, call);
    return value;
}

/* Are they so few that any cache has them? */
static bool are_few(tree bytes)
{
    return TREE_CODE(bytes) == INTEGER_CST && compare_tree_int(bytes, 1024) <= 0;
}

tree arg_cost_append(gimple_seq *seq, gcall *call, int64_t per, const call_cost &price)
{
    tree type = unsigned_type_for(units_type()), count = NULL_TREE;
    for (int argument : price.of) {
        tree value = argument ? gimple_call_arg(call, argument - 1) : gimple_call_lhs(call);
        if (price.kind != PRICED_INTEGERS)
            value = append_elements(seq, value);
        value = append_count(seq, gimple_convert(seq, type, value));
        count = count ? append_count(seq, gimple_build(seq, MULT_EXPR, type, count, value)) : value;
    }
    count = gimple_convert(seq, units_type(), count);
    if (price.far && !are_few(count))
        return append_move(seq, count, per, price.far * per / price.per);
    return gimple_build(seq, MULT_EXPR, units_type(), count, units_constant(per));
}
