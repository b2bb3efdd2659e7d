/* unset.cc - see unset.h.
 *
 * Variables in registers, which are SSA names without a definition, get one. Variables in memory are cleared
 * where their life begins: in the block that dominates all that mentions them, unless that block may be run
 * again while the variable lives. GCC marks the end of a variable's life by a clobber, except at the
 * function's end. What a variable-length array or alloca() takes from the stack is cleared, too, and a
 * function that ends without the value that it should return returns 0.
 */
#include "counting/unset.h"
#include <map>
#include <set>
#include <vector>

namespace
{
/* A block of alloca() that is larger is left as it is: programs that make stacks of their own move the stack
 * pointer to them so. */
const HOST_WIDE_INT most_cleared = 1 << 16;

/* A local variable in memory. */
struct local {
    tree variable;
    basic_block first = NULL;      /* dominates all mentions */
    std::map<int, bool> last_dies; /* by block: is the last that happens to the variable there a clobber? */
};

/* By DECL_UID, so that the order does not depend on addresses. */
using locals = std::map<unsigned, local>;

struct mention {
    locals *all;
    basic_block bb;
};

/* Where a nested function that leaves its callers by goto finds the frame: filled in before anything else. */
bool is_for_nonlocal_goto(tree v)
{
    return cfun->nonlocal_goto_save_area && get_base_address(cfun->nonlocal_goto_save_area) == v;
}

bool is_local(tree v)
{
    return VAR_P(v) && !is_for_nonlocal_goto(v) && auto_var_in_fn_p(v, current_function_decl) &&
           !is_gimple_reg(v) && !DECL_HARD_REGISTER(v) && !DECL_HAS_VALUE_EXPR_P(v) && DECL_SIZE_UNIT(v) &&
           TREE_CODE(DECL_SIZE_UNIT(v)) == INTEGER_CST && !integer_zerop(DECL_SIZE_UNIT(v));
}

bool note_mention(gimple *, tree base, tree, void *arg)
{
    mention *m = static_cast<mention *>(arg);
    base = get_base_address(base);
    if (!base || !is_local(base))
        return false;
    local &l = (*m->all)[DECL_UID(base)];
    l.variable = base;
    l.first = l.first ? nearest_common_dominator(CDI_DOMINATORS, l.first, m->bb) : m->bb;
    l.last_dies[m->bb->index] = false;
    return false;
}

void note(locals *all, basic_block bb, gimple *stmt)
{
    mention m = {all, bb};
    if (gimple_clobber_p(stmt)) {
        tree v = gimple_assign_lhs(stmt);
        auto l = DECL_P(v) ? all->find(DECL_UID(v)) : all->end();
        if (l != all->end())
            l->second.last_dies[bb->index] = true;
    } else if (!is_gimple_debug(stmt)) {
        walk_stmt_load_store_addr_ops(stmt, &m, note_mention, note_mention, note_mention);
    }
}

/* Twice, since a clobber may come before its variable's first mention in the order of blocks. */
locals find_locals(function *fun)
{
    locals all;
    for (int turn = 0; turn < 2; turn++) {
        basic_block bb;
        FOR_EACH_BB_FN (bb, fun) {
            for (gphi_iterator i = gsi_start_phis(bb); !gsi_end_p(i); gsi_next(&i))
                note(&all, bb, i.phi());
            for (gimple_stmt_iterator i = gsi_start_bb(bb); !gsi_end_p(i); gsi_next(&i))
                note(&all, bb, gsi_stmt(i));
        }
    }
    return all;
}

/* May a path lead from the end of bb to bb while the variable lives? */
bool comes_again(const local &l, basic_block bb)
{
    std::set<int> seen;
    std::vector<basic_block> open{bb};
    while (!open.empty()) {
        basic_block from = open.back();
        open.pop_back();
        auto event = l.last_dies.find(from->index);
        if (event != l.last_dies.end() && event->second)
            continue;
        edge e;
        edge_iterator ei;
        FOR_EACH_EDGE (e, ei, from->succs) {
            if (e->dest == bb)
                return true;
            if (seen.insert(e->dest->index).second)
                open.push_back(e->dest);
        }
    }
    return false;
}

bool find_variable(gimple *, tree base, tree, void *arg)
{
    return get_base_address(base) == arg;
}

bool mentions(gimple *stmt, tree v)
{
    return !is_gimple_debug(stmt) && !gimple_clobber_p(stmt) &&
           walk_stmt_load_store_addr_ops(stmt, v, find_variable, find_variable, find_variable);
}

/* Does the first statement that mentions a variable set all of it? */
bool sets_all(gimple *stmt, tree v)
{
    if (is_gimple_call(stmt))
        return gimple_call_lhs(stmt) == v;
    return is_gimple_assign(stmt) && gimple_assign_lhs(stmt) == v &&
           !walk_stmt_load_store_addr_ops(stmt, v, find_variable, NULL, find_variable);
}

tree zero_of(tree type)
{
    return is_gimple_reg_type(type) ? build_zero_cst(type) : build_constructor(type, NULL);
}

/* Does the variable's address come into the block where paths meet? What follows may use it under another
 * name. */
bool met_in(basic_block bb, tree v)
{
    for (gphi_iterator i = gsi_start_phis(bb); !gsi_end_p(i); gsi_next(&i))
        if (mentions(i.phi(), v))
            return true;
    return false;
}

void clear(const local &l)
{
    basic_block bb = l.first;
    while (comes_again(l, bb))
        bb = get_immediate_dominator(CDI_DOMINATORS, bb);
    if (bb == ENTRY_BLOCK_PTR_FOR_FN(cfun))
        bb = split_edge(single_succ_edge(bb));
    gimple *set = gimple_build_assign(l.variable, zero_of(TREE_TYPE(l.variable)));
    gimple_stmt_iterator gsi = gsi_after_labels(bb);
    bool met = met_in(bb, l.variable);
    while (!met && !gsi_end_p(gsi) && !mentions(gsi_stmt(gsi), l.variable) &&
           !(gsi_one_before_end_p(gsi) && stmt_ends_bb_p(gsi_stmt(gsi))))
        gsi_next(&gsi);
    if (gsi_end_p(gsi)) {
        gsi = gsi_last_bb(bb);
        gsi_insert_after(&gsi, set, GSI_NEW_STMT);
    } else if (met || !sets_all(gsi_stmt(gsi), l.variable)) {
        gsi_insert_before(&gsi, set, GSI_SAME_STMT);
    }
}

/* --- variables in registers --- */

bool is_never_set(tree name)
{
    tree v = SSA_NAME_VAR(name);
    if (virtual_operand_p(name) || has_zero_uses(name) || !gimple_nop_p(SSA_NAME_DEF_STMT(name)))
        return false;
    return !v || (VAR_P(v) && !DECL_HARD_REGISTER(v)) ||
           (TREE_CODE(v) == RESULT_DECL && !DECL_BY_REFERENCE(v));
}

/* Where paths meet, 0 comes over the edges on which the variable is not set. */
void set_in_phis(tree name)
{
    gimple *stmt;
    imm_use_iterator i;
    use_operand_p use;
    FOR_EACH_IMM_USE_STMT(stmt, i, name)
    if (gimple_code(stmt) == GIMPLE_PHI)
        FOR_EACH_IMM_USE_ON_STMT(use, i)
    SET_USE(use, build_zero_cst(TREE_TYPE(name)));
}

void set(tree name)
{
    if (!SSA_NAME_OCCURS_IN_ABNORMAL_PHI(name))
        set_in_phis(name);
    if (has_zero_uses(name))
        return;
    if (SSA_NAME_IS_DEFAULT_DEF(name))
        set_ssa_default_def(cfun, SSA_NAME_VAR(name), NULL_TREE);
    gimple *definition = gimple_build_assign(name, build_zero_cst(TREE_TYPE(name)));
    gimple_stmt_iterator gsi = gsi_after_labels(single_succ(ENTRY_BLOCK_PTR_FOR_FN(cfun)));
    gsi_insert_before(&gsi, definition, GSI_SAME_STMT);
}

void set_names(function *fun)
{
    unsigned i;
    tree name;
    auto_vec<tree> unset;
    FOR_EACH_SSA_NAME(i, name, fun)
    if (is_never_set(name))
        unset.safe_push(name);
    if (unset.is_empty())
        return;
    if (!single_pred_p(single_succ(ENTRY_BLOCK_PTR_FOR_FN(fun)))) /* a loop begins there */
        split_edge(single_succ_edge(ENTRY_BLOCK_PTR_FOR_FN(fun)));
    for (tree n : unset)
        set(n);
}

/* --- the stack's blocks, and results --- */

void clear_block(gcall *call)
{
    tree at = gimple_call_lhs(call), bytes = gimple_call_arg(call, 0);
    if (!at)
        return;
    gimple_seq seq = NULL;
    if (!gimple_call_alloca_for_var_p(call)) {
        tree type = TREE_TYPE(bytes), most = build_int_cst(type, most_cleared);
        tree small = gimple_build(&seq, LE_EXPR, boolean_type_node, bytes, most);
        bytes = gimple_build(&seq, COND_EXPR, type, small, bytes, build_zero_cst(type));
    }
    tree memset = builtin_decl_implicit(BUILT_IN_MEMSET);
    gimple_seq_add_stmt_without_update(&seq, gimple_build_call(memset, 3, at, integer_zero_node, bytes));
    gimple_stmt_iterator gsi = gsi_for_stmt(call);
    gsi_insert_seq_after(&gsi, seq, GSI_SAME_STMT);
}

void give_value(greturn *stmt)
{
    tree type = TREE_TYPE(TREE_TYPE(current_function_decl));
    if (gimple_return_retval(stmt) || VOID_TYPE_P(type) || !is_gimple_reg_type(type))
        return;
    gimple_return_set_retval(stmt, build_zero_cst(type));
    update_stmt(stmt);
}

void visit(gimple *stmt)
{
    if (gimple_call_builtin_p(stmt, BUILT_IN_ALLOCA) ||
        gimple_call_builtin_p(stmt, BUILT_IN_ALLOCA_WITH_ALIGN) ||
        gimple_call_builtin_p(stmt, BUILT_IN_ALLOCA_WITH_ALIGN_AND_MAX))
        clear_block(as_a<gcall *>(stmt));
    else if (greturn *r = dyn_cast<greturn *>(stmt))
        give_value(r);
}

const pass_data unset_data = {
    GIMPLE_PASS, "unset", OPTGROUP_NONE, TV_NONE, PROP_cfg | PROP_ssa, 0, 0, 0, TODO_update_ssa,
};

class unset_pass : public gimple_opt_pass
{
  public:
    explicit unset_pass(gcc::context *context) : gimple_opt_pass(unset_data, context) {}
    opt_pass *clone() override { return new unset_pass(m_ctxt); }
    unsigned int execute(function *fun) override
    {
        basic_block bb;
        FOR_EACH_BB_FN (bb, fun)
            for (gimple_stmt_iterator i = gsi_start_bb(bb); !gsi_end_p(i); gsi_next(&i))
                visit(gsi_stmt(i));
        set_names(fun);
        calculate_dominance_info(CDI_DOMINATORS);
        for (auto &l : find_locals(fun))
            clear(l.second);
        mark_virtual_operands_for_renaming(fun);
        free_dominance_info(CDI_DOMINATORS);
        return 0;
    }
};
} // namespace

opt_pass *unset_make_pass()
{
    return new unset_pass(g);
}
