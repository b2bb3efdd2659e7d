/* cache.cc - see cache.h. */
#include "gcc.h"
#include "cache.h"
#include "costs.h"

namespace
{
cache_costs cache;

/* long name(void *address, long sets, long ways, long line, long miss) */
tree function(const char *name)
{
    tree l = units_type();
    tree type = build_function_type_list(l, ptr_type_node, l, l, l, l, NULL_TREE);
    return build_fn_decl(name, type);
}

/* The address of what a reference to memory names; of a bit-field, the address of what holds it. */
tree address_of(tree ref)
{
    tree base = get_base_address(ref);
    if (TREE_CODE(base) == TARGET_MEM_REF)
        return tree_mem_ref_addr(ptr_type_node, unshare_expr(base));
    while (handled_component_p(ref) && TREE_CODE(ref) != COMPONENT_REF && TREE_CODE(ref) != ARRAY_REF)
        ref = TREE_OPERAND(ref, 0);
    if (TREE_CODE(ref) == COMPONENT_REF && DECL_BIT_FIELD(TREE_OPERAND(ref, 1)))
        ref = TREE_OPERAND(ref, 0);
    if (DECL_P(base))
        TREE_ADDRESSABLE(base) = 1;
    return build_fold_addr_expr(unshare_expr(ref));
}

void look_up(gimple *stmt, tree ref, const char *name, int64_t miss, vec<tree> &units)
{
    if (!costs_is_memory(ref) || (VAR_P(get_base_address(ref)) && DECL_HARD_REGISTER(get_base_address(ref))))
        return;
    gimple_stmt_iterator gsi = gsi_for_stmt(stmt);
    tree address = force_gimple_operand_gsi(&gsi, fold_convert(ptr_type_node, address_of(ref)), true,
                                            NULL_TREE, true, GSI_SAME_STMT);
    tree l = units_type(), answer = make_ssa_name(l);
    gcall *call =
        gimple_build_call(function(name), 5, address, build_int_cst(l, cache.sets),
                          build_int_cst(l, cache.ways), build_int_cst(l, cache.line), build_int_cst(l, miss));
    gimple_call_set_lhs(call, answer);
    gsi_insert_before(&gsi, call, GSI_SAME_STMT);
    units.safe_push(answer);
}
} // namespace

void cache_use(const cache_costs &c)
{
    cache = c;
}

bool cache_is_simulated()
{
    return cache.sets;
}

void cache_look_up(gimple *stmt, vec<tree> &units)
{
    if (!cache_is_simulated() || !is_gimple_assign(stmt) || gimple_clobber_p(stmt))
        return;
    if (gimple_assign_single_p(stmt))
        look_up(stmt, gimple_assign_rhs1(stmt), "nxc_cache_load", cache.load_miss, units);
    look_up(stmt, gimple_assign_lhs(stmt), "nxc_cache_store", cache.store_miss, units);
}
