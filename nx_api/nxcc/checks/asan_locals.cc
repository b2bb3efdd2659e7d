/* asan_locals.cc - see asan_locals.h. */
#include "checks/asan_locals.h"
#include "checks/asan_code.h"
#include "checks/race_sites.h"
#include "../contract/asan.h"
#include "../contract/races.h"
#include "calls.h"
#include "gimple-walk.h"
#include <vector>

namespace
{
const int64_t most_bytes = 1 << 30; /* of a variable in a frame */

struct local {
    tree decl;
    size_t bytes;
};

bool note_base(gimple *, tree base, tree, void *all)
{
    if (VAR_P(base))
        static_cast<hash_set<tree> *>(all)->add(base);
    return false;
}

/* The variables that the function's statements use in memory. */
void find_used(function *f, hash_set<tree> *used)
{
    basic_block bb;
    FOR_EACH_BB_FN (bb, f)
        for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi))
            if (!is_gimple_debug(gsi_stmt(gsi)) && !gimple_clobber_p(gsi_stmt(gsi)))
                walk_stmt_load_store_addr_ops(gsi_stmt(gsi), used, note_base, note_base, note_base);
}

bool has_place_in_frame(function *f, tree decl)
{
    return !is_global_var(decl) && auto_var_in_fn_p(decl, f->decl) && !DECL_HAS_VALUE_EXPR_P(decl) &&
           !DECL_HARD_REGISTER(decl) && !is_gimple_reg(decl) && DECL_NAME(decl);
}

bool is_protected(function *f, tree decl)
{
    tree size = DECL_SIZE_UNIT(decl);
    return has_place_in_frame(f, decl) && (TREE_ADDRESSABLE(decl) || AGGREGATE_TYPE_P(TREE_TYPE(decl))) &&
           size && tree_fits_shwi_p(size) && tree_to_shwi(size) > 0 && tree_to_shwi(size) < most_bytes;
}

std::vector<local> find_locals(function *f)
{
    hash_set<tree> used;
    std::vector<local> all;
    tree decl;
    unsigned i;
    find_used(f, &used);
    FOR_EACH_LOCAL_DECL(f, i, decl)
    if (VAR_P(decl) && used.contains(decl) && is_protected(f, decl))
        all.push_back({decl, (size_t)tree_to_shwi(DECL_SIZE_UNIT(decl))});
    return all;
}

void enlarge(const local &v)
{
    size_t bytes = nxc_asan_zone_at(v.bytes) + NXC_ASAN_ZONE;
    DECL_SIZE_UNIT(v.decl) = size_int(bytes);
    DECL_SIZE(v.decl) = bitsize_int(bytes * BITS_PER_UNIT);
    TREE_ADDRESSABLE(v.decl) = 1;
    if (DECL_ALIGN_UNIT(v.decl) < NXC_ASAN_GRAIN)
        SET_DECL_ALIGN(v.decl, NXC_ASAN_GRAIN * BITS_PER_UNIT);
}

/* The variable as what its type has: GCC copies a variable with all the bytes that it has now. */
tree without_zone(tree decl)
{
    return build2(MEM_REF, TREE_TYPE(decl), build_fold_addr_expr(decl),
                  build_zero_cst(build_pointer_type(TREE_TYPE(decl))));
}

/* Adapts what mentions the variables: copies of them, and the ends of their scopes, which are taken out. */
void adapt(function *f, const std::vector<local> &all)
{
    hash_set<tree> decls;
    basic_block bb;
    for (const local &v : all)
        decls.add(v.decl);
    FOR_EACH_BB_FN (bb, f)
        for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi);) {
            gimple *stmt = gsi_stmt(gsi);
            if (gimple_assign_single_p(stmt) && decls.contains(gimple_assign_rhs1(stmt))) {
                gimple_assign_set_rhs1(stmt, without_zone(gimple_assign_rhs1(stmt)));
                update_stmt(stmt);
            }
            if (gimple_clobber_p(stmt) && decls.contains(get_base_address(gimple_assign_lhs(stmt)))) {
                unlink_stmt_vdef(stmt);
                gsi_remove(&gsi, true);
                release_defs(stmt);
            } else {
                gsi_next(&gsi);
            }
        }
}

void mark_at_beginning(function *f, const std::vector<local> &all)
{
    basic_block first = split_edge(single_succ_edge(ENTRY_BLOCK_PTR_FOR_FN(f)));
    gimple_stmt_iterator gsi = gsi_start_bb(first);
    for (const local &v : all) {
        size_t site = race_site_of_declaration(v.decl, f->decl, NXC_RACE_LOCAL);
        gsi_insert_after(&gsi, asan_code_begin_local(v.decl, v.bytes, site), GSI_NEW_STMT);
    }
}

/* --- blocks of alloca --- */

std::vector<gcall *> find_calls(function *f, bool (*is_wanted)(gimple *))
{
    std::vector<gcall *> all;
    basic_block bb;
    FOR_EACH_BB_FN (bb, f)
        for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi))
            if (is_gimple_call(gsi_stmt(gsi)) && is_wanted(gsi_stmt(gsi)))
                all.push_back(as_a<gcall *>(gsi_stmt(gsi)));
    return all;
}

bool gives_block(gimple *call)
{
    return gimple_alloca_call_p(call) && gimple_call_lhs(call);
}

bool ends_blocks(gimple *call)
{
    return gimple_call_builtin_p(call, BUILT_IN_STACK_RESTORE);
}

tree insert_sum(gimple_stmt_iterator *before, tree_code code, tree a, size_t b)
{
    tree sum = make_ssa_name(size_type_node);
    gsi_insert_before(before,
                      gimple_build_assign(sum, code, a, build_int_cst(size_type_node, (HOST_WIDE_INT)b)),
                      GSI_SAME_STMT);
    return sum;
}

void protect_block(gcall *call)
{
    gimple_stmt_iterator gsi = gsi_for_stmt(call);
    tree bytes = make_ssa_name(size_type_node);
    gsi_insert_before(&gsi, gimple_build_assign(bytes, NOP_EXPR, gimple_call_arg(call, 0)), GSI_SAME_STMT);
    tree last = insert_sum(&gsi, PLUS_EXPR, bytes, NXC_ASAN_GRAIN - 1);
    tree zone_at = insert_sum(&gsi, BIT_AND_EXPR, last, -(size_t)NXC_ASAN_GRAIN);
    gimple_call_set_arg(call, 0, insert_sum(&gsi, PLUS_EXPR, zone_at, NXC_ASAN_ZONE));
    update_stmt(call);
    const char *name = gimple_call_alloca_for_var_p(call) ? "an array of variable size" : "a block of alloca";
    size_t site = race_site(call, name, 0, NXC_RACE_LOCAL);
    gsi_insert_after(&gsi, asan_code_begin_block(gimple_call_lhs(call), bytes, site), GSI_NEW_STMT);
}

void protect_blocks(function *f, const std::vector<gcall *> &blocks)
{
    for (gcall *call : blocks)
        protect_block(call);
    for (gcall *call : find_calls(f, ends_blocks)) {
        gimple_stmt_iterator gsi = gsi_for_stmt(call);
        gsi_insert_before(&gsi, asan_code_end_blocks(gimple_call_arg(call, 0)), GSI_SAME_STMT);
    }
}

/* --- returns --- */

void end_frame(gimple_stmt_iterator gsi, const std::vector<local> &all, bool has_blocks)
{
    if (has_blocks)
        gsi_insert_before(&gsi, asan_code_end_blocks(NULL_TREE), GSI_SAME_STMT);
    else
        for (const local &v : all)
            gsi_insert_before(&gsi, asan_code_end_local(v.decl, v.bytes), GSI_SAME_STMT);
}

void end_at_returns(function *f, const std::vector<local> &all, bool has_blocks)
{
    edge e;
    edge_iterator i;
    FOR_EACH_EDGE (e, i, EXIT_BLOCK_PTR_FOR_FN(f)->preds) {
        gimple_stmt_iterator gsi = gsi_last_nondebug_bb(e->src);
        if (!gsi_end_p(gsi) && gimple_code(gsi_stmt(gsi)) == GIMPLE_RETURN)
            end_frame(gsi, all, has_blocks);
    }
}
} // namespace

void asan_locals_protect(function *f)
{
    std::vector<local> all = find_locals(f);
    std::vector<gcall *> blocks = find_calls(f, gives_block);
    if (all.empty() && blocks.empty())
        return;
    for (const local &v : all)
        enlarge(v);
    adapt(f, all);
    mark_at_beginning(f, all);
    protect_blocks(f, blocks);
    end_at_returns(f, all, !blocks.empty());
}
