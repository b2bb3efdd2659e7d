/* arg_cost.cc - see arg_cost.h. */
#include "arg_cost.h"

/* Appends the number of elements of a Fortran array, given by its descriptor: a call of
 * nx_api/libgfortran/elements.c. */
static tree append_elements(gimple_seq *seq, tree array)
{
    if (!POINTER_TYPE_P(TREE_TYPE(array)))
        return NULL_TREE;
    tree count =
        build_fn_decl("nx_elements", build_function_type_list(units_type(), ptr_type_node, NULL_TREE));
    gcall *call = gimple_build_call(count, 1, array);
    tree value = make_ssa_name(units_type(), call);
    gimple_call_set_lhs(call, value);
    gimple_seq_add_stmt_without_update(seq, call);
    return value;
}

tree arg_cost_append(gimple_seq *seq, gcall *call, int64_t per, const std::vector<int> &of, bool elements)
{
    tree amount = units_constant(per);
    for (int argument : of) {
        tree value = argument ? gimple_call_arg(call, argument - 1) : gimple_call_lhs(call);
        if (elements && !(value = append_elements(seq, value)))
            return NULL_TREE;
        if (!INTEGRAL_TYPE_P(TREE_TYPE(value)))
            return NULL_TREE;
        value = gimple_convert(seq, units_type(), value);
        if (!argument) /* a negative result is an error code */
            value = gimple_build(seq, MAX_EXPR, units_type(), value, units_constant(0));
        amount = gimple_build(seq, MULT_EXPR, units_type(), amount, value);
    }
    return amount;
}
