/* race_loops.cc - see race_loops.h. */
#include "checks/race_loops.h"
#include "base/costs.h"
#include "checks/race_code.h"
#include "checks/race_reach.h"
#include "checks/race_sites.h"

namespace
{
const size_t most_accesses = 8; /* of one loop: each takes a register or a word of the stack */

bool is_preemption(gimple *stmt)
{
    gasm *code = dyn_cast<gasm *>(stmt);
    return code && strstr(gimple_asm_string(code), "call\tnxc_enter");
}

/* --- which accesses ------------------------------------------------------------------------------------- */

bool has_complex_entry(class loop *loop)
{
    edge e;
    edge_iterator ei;
    FOR_EACH_EDGE (e, ei, loop->header->preds)
        if (e->flags & EDGE_COMPLEX)
            return true;
    return false;
}

/* Does control leave the loop for others only at its exits and preemptions? */
bool is_closed(class loop *loop)
{
    basic_block *body = get_loop_body(loop);
    bool closed = !loop->inner && loop_latch_edge(loop) && !has_complex_entry(loop);
    for (unsigned i = 0; closed && i < loop->num_nodes; i++) {
        edge e;
        edge_iterator ei;
        FOR_EACH_EDGE (e, ei, body[i]->succs)
            closed = closed && !(e->flags & EDGE_COMPLEX);
        for (gimple_stmt_iterator gsi = gsi_start_bb(body[i]); !gsi_end_p(gsi); gsi_next(&gsi)) {
            gcall *call = dyn_cast<gcall *>(gsi_stmt(gsi));
            bool other_code = gimple_code(gsi_stmt(gsi)) == GIMPLE_ASM && !is_preemption(gsi_stmt(gsi));
            closed = closed && !other_code && (!call || costs_call_is_uncounted(call));
        }
    }
    free(body);
    return closed;
}

bool is_invariant(class loop *loop, tree value)
{
    if (!value || TREE_CODE(value) != SSA_NAME)
        return true;
    basic_block bb = gimple_bb(SSA_NAME_DEF_STMT(value));
    return !bb || !flow_bb_inside_loop_p(loop, bb);
}

/* The value of which another is a conversion of the same size. */
tree converted(tree value)
{
    gassign *def = dyn_cast<gassign *>(SSA_NAME_DEF_STMT(value));
    if (!def || !CONVERT_EXPR_CODE_P(gimple_assign_rhs_code(def)))
        return value;
    tree from = gimple_assign_rhs1(def);
    bool same =
        TREE_CODE(from) == SSA_NAME && TYPE_PRECISION(TREE_TYPE(from)) == TYPE_PRECISION(TREE_TYPE(value));
    return same ? from : value;
}

/* A value that is the loop's own, with what it is at the beginning of a trip; NULL: it is none. */
gphi *value_of_trip(class loop *loop, tree value)
{
    gphi *phi = dyn_cast<gphi *>(SSA_NAME_DEF_STMT(converted(value)));
    return phi && gimple_bb(phi) == loop->header ? phi : NULL;
}

/* By how much it grows in each trip, if by a constant; otherwise 0. */
int64_t step_of(class loop *loop, gphi *phi)
{
    tree next = phi ? PHI_ARG_DEF_FROM_EDGE(phi, loop_latch_edge(loop)) : NULL_TREE;
    gassign *add = next && TREE_CODE(next) == SSA_NAME ? dyn_cast<gassign *>(SSA_NAME_DEF_STMT(next)) : NULL;
    if (!add ||
        (gimple_assign_rhs_code(add) != PLUS_EXPR && gimple_assign_rhs_code(add) != POINTER_PLUS_EXPR) ||
        gimple_assign_rhs1(add) != gimple_phi_result(phi) ||
        TREE_CODE(gimple_assign_rhs2(add)) != INTEGER_CST)
        return 0;
    return int_cst_value(gimple_assign_rhs2(add));
}

/* The parts of an address that may vary, with the bytes that 1 of each is. */
struct term {
    tree value;
    int64_t bytes;
};

int64_t constant_or_0(tree value)
{
    return value && tree_fits_shwi_p(value) ? tree_to_shwi(value) : 0;
}

std::vector<term> terms_of(tree ref)
{
    std::vector<term> all;
    for (; handled_component_p(ref); ref = TREE_OPERAND(ref, 0))
        if (TREE_CODE(ref) == ARRAY_REF)
            all.push_back({TREE_OPERAND(ref, 1), constant_or_0(array_ref_element_size(ref))});
    if (TREE_CODE(ref) == MEM_REF)
        all.push_back({TREE_OPERAND(ref, 0), 1});
    if (TREE_CODE(ref) == TARGET_MEM_REF) {
        all.push_back({TMR_BASE(ref), 1});
        all.push_back({TMR_INDEX(ref), TMR_STEP(ref) ? constant_or_0(TMR_STEP(ref)) : 1});
        all.push_back({TMR_INDEX2(ref), 1});
    }
    return all;
}

/* Does the address move by the bytes of the access in each trip? Fills in varying and down. */
bool moves_without_gaps(race_loop_access &a)
{
    int64_t move = 0;
    for (const term &t : terms_of(a.ref)) {
        if (is_invariant(a.loop, t.value))
            continue;
        if (a.varying)
            return false;
        a.varying = t.value;
        a.value = value_of_trip(a.loop, t.value);
        move = step_of(a.loop, a.value) * t.bytes;
    }
    a.down = move < 0;
    return a.varying && (move == a.bytes || move == -a.bytes);
}

/* Is it the same in all trips whether the access comes before the end of a block or behind it? */
bool is_before_or_behind(basic_block access, basic_block end)
{
    return dominated_by_p(CDI_DOMINATORS, end, access) || dominated_by_p(CDI_DOMINATORS, access, end);
}

/* The blocks at whose ends the loop is left for its exits and its preemptions. */
std::vector<basic_block> ends_of(class loop *loop)
{
    std::vector<basic_block> all;
    auto_vec<edge> exits = get_loop_exit_edges(loop);
    for (edge e : exits)
        all.push_back(e->src);
    basic_block *body = get_loop_body(loop);
    for (unsigned i = 0; i < loop->num_nodes; i++)
        for (gimple_stmt_iterator gsi = gsi_start_bb(body[i]); !gsi_end_p(gsi); gsi_next(&gsi))
            if (is_preemption(gsi_stmt(gsi)))
                all.push_back(single_pred_p(body[i]) ? single_pred(body[i]) : body[i]);
    free(body);
    return all;
}

bool can_be_told(race_loop_access &a)
{
    basic_block bb = gimple_bb(a.stmt);
    tree size = TYPE_SIZE_UNIT(TREE_TYPE(a.ref));
    bool bit_field = TREE_CODE(a.ref) == COMPONENT_REF && DECL_BIT_FIELD(TREE_OPERAND(a.ref, 1));
    if (!race_reach(a.ref) || TREE_THIS_VOLATILE(a.ref) || bit_field || !size || !tree_fits_shwi_p(size))
        return false;
    tree_code code = TREE_CODE(a.ref);
    if (code != MEM_REF && code != TARGET_MEM_REF && code != ARRAY_REF && code != COMPONENT_REF)
        return false;
    a.bytes = tree_to_shwi(size);
    if (!moves_without_gaps(a) || !dominated_by_p(CDI_DOMINATORS, loop_latch_edge(a.loop)->src, bb))
        return false;
    for (basic_block end : ends_of(a.loop))
        if (!is_before_or_behind(bb, end))
            return false;
    return true;
}

void add_accesses(class loop *loop, std::vector<race_loop_access> &all)
{
    size_t before = all.size();
    basic_block *body = get_loop_body_in_dom_order(loop);
    for (unsigned i = 0; i < loop->num_nodes; i++)
        for (gimple_stmt_iterator gsi = gsi_start_nondebug_bb(body[i]); !gsi_end_p(gsi);
             gsi_next_nondebug(&gsi)) {
            gimple *stmt = gsi_stmt(gsi);
            if (!gimple_assign_single_p(stmt) || gimple_clobber_p(stmt))
                continue;
            for (bool write : {false, true}) {
                tree ref = write ? gimple_assign_lhs(stmt) : gimple_assign_rhs1(stmt);
                race_loop_access a = {stmt, ref, write, loop, NULL_TREE, NULL, 0, false};
                if (all.size() - before < most_accesses && can_be_told(a))
                    all.push_back(a);
            }
        }
    free(body);
}

/* --- the code ------------------------------------------------------------------------------------------- */

tree append(gimple_seq *seq, tree expression)
{
    gimple_seq more = NULL;
    tree value = force_gimple_operand(expression, &more, true, NULL_TREE);
    gimple_seq_add_seq_without_update(seq, more);
    return value;
}

/* Appends the address of the access where its varying operand has a value. */
tree append_address(gimple_seq *seq, const race_loop_access &a, tree value)
{
    tree ref = unshare_expr(a.ref);
    tree address =
        TREE_CODE(ref) == TARGET_MEM_REF ? tree_mem_ref_addr(ptr_type_node, ref) : build_fold_addr_expr(ref);
    if (value != a.varying)
        address = simplify_replace_tree(address, a.varying,
                                        fold_convert(TREE_TYPE(a.varying), unshare_expr(value)));
    return append(seq, fold_convert(units_type(), address));
}

/* The one range of an access in its loop. */
class range
{
  public:
    range(const race_loop_access &access, size_t table_site)
        : a(access), site(table_site), first(create_tmp_reg(units_type(), "first"))
    {
    }
    void begin(edge entry) const;
    void end(edge exit) const;
    void around(gimple *preemption, basic_block test) const;

  private:
    tree append_here(gimple_seq *seq, basic_block end) const;
    void append_telling(gimple_seq *seq, tree here) const;

    const race_loop_access &a;
    size_t site;
    tree first; /* the address of the first access that has not been told */
};

void range::begin(edge entry) const
{
    gimple_seq seq = NULL;
    tree value = PHI_ARG_DEF_FROM_EDGE(a.value, entry);
    gimple_seq_add_stmt_without_update(&seq, gimple_build_assign(first, append_address(&seq, a, value)));
    gsi_insert_seq_on_edge(entry, seq);
}

/* Appends the address of the next access, at the end of a block. */
tree range::append_here(gimple_seq *seq, basic_block end) const
{
    tree here = append_address(seq, a, gimple_phi_result(a.value));
    if (!dominated_by_p(CDI_DOMINATORS, end, gimple_bb(a.stmt)))
        return here;
    return append(seq, build2(PLUS_EXPR, units_type(), here, units_constant(a.down ? -a.bytes : a.bytes)));
}

void range::append_telling(gimple_seq *seq, tree here) const
{
    tree from = first, to = here;
    if (a.down) {
        from = append(seq, build2(PLUS_EXPR, units_type(), here, units_constant(a.bytes)));
        to = append(seq, build2(PLUS_EXPR, units_type(), first, units_constant(a.bytes)));
    }
    tree bytes = append(seq, build2(MINUS_EXPR, units_type(), to, from));
    gasm *code = race_code_range(from, bytes, site);
    gimple_set_location(code, gimple_location(a.stmt));
    gimple_seq_add_stmt_without_update(seq, code);
}

void range::end(edge exit) const
{
    gimple_seq seq = NULL;
    append_telling(&seq, append_here(&seq, exit->src));
    gsi_insert_seq_on_edge(exit, seq);
}

void range::around(gimple *preemption, basic_block test) const
{
    gimple_seq seq = NULL;
    tree here = append_here(&seq, test);
    append_telling(&seq, here);
    gimple_seq_add_stmt_without_update(&seq, gimple_build_assign(first, here));
    gimple_stmt_iterator gsi = gsi_for_stmt(preemption);
    gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
}
} // namespace

std::vector<race_loop_access> race_loops_find(function *fun)
{
    std::vector<race_loop_access> all;
    for (auto loop : loops_list(fun, LI_ONLY_INNERMOST))
        if (is_closed(loop))
            add_accesses(loop, all);
    return all;
}

void race_loops_tell(const race_loop_access &a, size_t site)
{
    range r(a, site);
    edge e;
    edge_iterator ei;
    FOR_EACH_EDGE (e, ei, a.loop->header->preds)
        if (e != loop_latch_edge(a.loop))
            r.begin(e);
    auto_vec<edge> exits = get_loop_exit_edges(a.loop);
    for (edge exit : exits)
        r.end(exit);
    basic_block *body = get_loop_body(a.loop);
    for (unsigned i = 0; i < a.loop->num_nodes; i++)
        for (gimple_stmt_iterator gsi = gsi_start_bb(body[i]); !gsi_end_p(gsi); gsi_next(&gsi))
            if (is_preemption(gsi_stmt(gsi)))
                r.around(gsi_stmt(gsi), single_pred_p(body[i]) ? single_pred(body[i]) : body[i]);
    free(body);
}
