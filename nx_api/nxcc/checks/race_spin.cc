/* race_spin.cc - see race_spin.h. */
#include "checks/race_spin.h"
#include "base/costs.h"
#include "checks/race_reach.h"
#include "checks/race_written.h"
#include "tree-ssa-alias.h"
#include <vector>

namespace
{
/* NX's calls that a waiting loop may make; Fortran's names end in an underscore. */
bool lets_handlers_run(gcall *call)
{
    static const std::set<std::string> calls = {"flick",    "masktrap", "iprobe",  "iprobex", "infocount",
                                                "infonode", "infotype", "infopid", "dclock",  "mclock",
                                                "mynode",   "numnodes", "mypid",   "myhost"};
    tree decl = gimple_call_fndecl(call);
    if (!decl || !DECL_NAME(decl))
        return false;
    std::string name = IDENTIFIER_POINTER(DECL_NAME(decl));
    name.erase(0, name.find_first_not_of('_'));
    name.erase(name.find_last_not_of('_') + 1);
    return calls.count(name) > 0;
}

/* One loop, and the reads whose values decide an exit of it. */
class waiting
{
  public:
    waiting(class loop *l, const std::vector<basic_block> &of_loop) : loop(l), blocks(of_loop) {}
    std::set<gimple *> find();

  private:
    bool may_change(tree ref) const;
    bool is_fixed(tree ref, int depth) const;
    bool depends_on_reads(tree value, std::set<gimple *> &reads, int depth) const;
    bool is_in(gimple *stmt) const;

    class loop *loop;
    const std::vector<basic_block> &blocks;
};

bool waiting::is_in(gimple *stmt) const
{
    return gimple_bb(stmt) && flow_bb_inside_loop_p(loop, gimple_bb(stmt));
}

/* May a statement write what a reference reads? */
bool may_write(gimple *stmt, tree ref)
{
    if (gcall *call = dyn_cast<gcall *>(stmt))
        return !lets_handlers_run(call) && !costs_call_is_uncounted(call);
    tree to = is_gimple_assign(stmt) ? gimple_assign_lhs(stmt) : NULL_TREE;
    return to && costs_is_memory(to) && !race_reach_is_own(get_base_address(to)) && refs_may_alias_p(ref, to);
}

/* May the loop? */
bool waiting::may_change(tree ref) const
{
    for (basic_block bb : blocks)
        for (gimple_stmt_iterator gsi = gsi_start_nondebug_bb(bb); !gsi_end_p(gsi); gsi_next_nondebug(&gsi))
            if (may_write(gsi_stmt(gsi), ref))
                return true;
    return false;
}

/* Has the reference the same address in all trips, unless others change a pointer? */
bool waiting::is_fixed(tree ref, int depth) const
{
    std::set<gimple *> pointers;
    auto varies = [&](tree part) {
        return part && TREE_CODE(part) == SSA_NAME && !depends_on_reads(part, pointers, depth);
    };
    for (; handled_component_p(ref); ref = TREE_OPERAND(ref, 0))
        if (TREE_CODE(ref) == ARRAY_REF && varies(TREE_OPERAND(ref, 1)))
            return false;
    for (int i = 0; !DECL_P(ref) && i < TREE_OPERAND_LENGTH(ref); i++)
        if (varies(TREE_OPERAND(ref, i)))
            return false;
    return true;
}

/* Does a value depend on nothing in the loop but reads that only others can change? Collects them. */
bool waiting::depends_on_reads(tree value, std::set<gimple *> &reads, int depth) const
{
    if (TREE_CODE(value) != SSA_NAME)
        return is_gimple_min_invariant(value);
    gimple *def = SSA_NAME_DEF_STMT(value);
    if (!is_in(def))
        return true;
    gassign *assigned = dyn_cast<gassign *>(def);
    if (!assigned || depth == 0)
        return false;
    tree first = gimple_assign_rhs1(assigned);
    if (gimple_assign_single_p(assigned) && costs_is_memory(first)) {
        reads.insert(def);
        return is_fixed(first, depth - 1) && !may_change(first);
    }
    for (unsigned i = 1; i < gimple_num_ops(assigned); i++)
        if (!depends_on_reads(gimple_op(assigned, i), reads, depth - 1))
            return false;
    return true;
}

std::set<gimple *> waiting::find()
{
    std::set<gimple *> all;
    auto_vec<edge> exits = get_loop_exit_edges(loop);
    for (edge e : exits) {
        gimple_stmt_iterator gsi = gsi_last_nondebug_bb(e->src);
        gcond *test = gsi_end_p(gsi) ? NULL : dyn_cast<gcond *>(gsi_stmt(gsi));
        std::set<gimple *> reads;
        if (test && depends_on_reads(gimple_cond_lhs(test), reads, 8) &&
            depends_on_reads(gimple_cond_rhs(test), reads, 8))
            all.insert(reads.begin(), reads.end());
    }
    return all;
}

/* Do two statements read the same in the same place of the source? */
bool are_copies(gimple *a, gimple *b)
{
    tree x = gimple_assign_rhs1(a), y = gimple_assign_rhs1(b);
    return race_location(a) == race_location(b) && race_location(a) != UNKNOWN_LOCATION &&
           TREE_CODE(x) == TREE_CODE(y) && (operand_equal_p(x, y, OEP_ADDRESS_OF) || !DECL_P(x));
}

/* Adds the reads of loops' conditions that GCC has put before the loops. */
void add_copies(function *fun, std::set<gimple *> &reads)
{
    std::set<gimple *> in_loops = reads;
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun)
        for (gimple_stmt_iterator gsi = gsi_start_nondebug_bb(bb); !gsi_end_p(gsi); gsi_next_nondebug(&gsi))
            for (gimple *read : in_loops)
                if (gimple_assign_single_p(gsi_stmt(gsi)) && are_copies(gsi_stmt(gsi), read))
                    reads.insert(gsi_stmt(gsi));
}
} // namespace

std::set<gimple *> race_spin_find(function *fun)
{
    std::set<gimple *> all;
    for (auto loop : loops_list(fun, 0)) {
        basic_block *body = get_loop_body(loop);
        std::vector<basic_block> blocks(body, body + loop->num_nodes);
        free(body);
        std::set<gimple *> reads = waiting(loop, blocks).find();
        all.insert(reads.begin(), reads.end());
    }
    add_copies(fun, all);
    return all;
}
