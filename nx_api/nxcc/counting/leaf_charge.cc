/* leaf_charge.cc - see leaf_charge.h. Functions are identified by their DECL_UID, which never changes. */
#include "counting/leaf_charge.h"
#include "base/costs.h"
#include "counting/profile.h"
#include <map>
#include <set>

namespace
{
std::map<unsigned, int64_t> leaves; /* the units of each caller-charged leaf */
std::set<unsigned> called;          /* functions called by those compiled so far */

/* Are all its calls in this file, by its name, and still to be compiled? */
bool has_known_callers(function *fun)
{
    cgraph_node *node = cgraph_node::get(fun->decl);
    return node && node->local && !node->has_aliases_p() && !called.count(DECL_UID(fun->decl));
}

bool is_plain(gimple *stmt)
{
    gcall *call = dyn_cast<gcall *>(stmt);
    const call_cost *price;
    if (gimple_code(stmt) == GIMPLE_ASM ||
        (call && (!costs_call_is_uncounted(call) || costs_of_call(call, &price))))
        return false;
    /* the profile attributes a leaf's cost to one function */
    return !profile_on || (!costs_priced_call(stmt) &&
                           DECL_ORIGIN(costs_written_in(stmt)) == DECL_ORIGIN(current_function_decl));
}

/* Adds the cost of bb. False: the cost varies. */
bool add_cost(basic_block bb, int64_t *units)
{
    for (gimple_stmt_iterator gsi = gsi_start_nondebug_bb(bb); !gsi_end_p(gsi); gsi_next_nondebug(&gsi)) {
        if (!is_plain(gsi_stmt(gsi)))
            return false;
        *units += costs_of(gsi_stmt(gsi));
    }
    return true;
}

/* Is the cost the same on all paths? Goes through the blocks in reverse post-order, so that a block comes
 * after its predecessors, and compares the units up to their ends. */
bool costs_always_the_same(function *fun, int64_t *units)
{
    std::map<int, int64_t> until; /* blocks' ends, by index */
    auto_vec<int> order;
    order.safe_grow(n_basic_blocks_for_fn(fun));
    int n = pre_and_rev_post_order_compute_fn(fun, NULL, order.address(), true);
    for (int i = 0; i < n; i++) {
        basic_block bb = BASIC_BLOCK_FOR_FN(fun, order[i]);
        edge e;
        edge_iterator ei;
        bool first = true;
        until[bb->index] = 0;
        FOR_EACH_EDGE (e, ei, bb->preds) {
            auto before = until.find(e->src->index);
            if ((e->flags & EDGE_COMPLEX) || e->src == bb || before == until.end() ||
                (!first && before->second != until[bb->index]))
                return false;
            until[bb->index] = before->second;
            first = false;
        }
        if (bb->index >= NUM_FIXED_BLOCKS && (!EDGE_COUNT(bb->succs) || !add_cost(bb, &until[bb->index])))
            return false;
    }
    *units = until[EXIT_BLOCK];
    return true;
}
} // namespace

bool leaf_charge_is_call(gimple *stmt)
{
    tree callee = is_gimple_call(stmt) ? gimple_call_fndecl(stmt) : NULL_TREE;
    return callee && leaves.count(DECL_UID(callee));
}

int64_t leaf_charge_cost(gimple *stmt)
{
    return leaf_charge_is_call(stmt) ? leaves[DECL_UID(gimple_call_fndecl(stmt))] : 0;
}

void leaf_charge_note_call(gcall *call)
{
    if (tree callee = gimple_call_fndecl(call))
        called.insert(DECL_UID(callee));
}

bool leaf_charge_accept(function *fun)
{
    int64_t units;
    if (!has_known_callers(fun) || !costs_always_the_same(fun, &units))
        return false;
    leaves[DECL_UID(fun->decl)] = units;
    return true;
}
