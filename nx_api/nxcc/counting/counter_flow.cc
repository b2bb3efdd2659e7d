/* counter_flow.cc - see counter_flow.h. */
#include "counting/counter_flow.h"

namespace
{
/* What a statement, or a block, does with the counter in memory. */
enum counter_use { NOTHING, LOAD, STORE, SHOW /* to code that may read and change the counter */ };

class counter_flow
{
  public:
    counter_flow(function *f, tree c, bool (*n)(gimple *));
    void replace_loads();
    void remove_stores();

  private:
    counter_use use_in(gimple *stmt) const;
    bool is_known_before(basic_block bb) const;
    bool is_wanted_behind(basic_block bb) const;
    void replace_loads(basic_block bb, tree now);
    void remove_stores(basic_block bb);

    function *fun;
    tree counter;
    bool (*needs_counter)(gimple *);
    std::vector<counter_use> first, last; /* in each block, by index */
    std::vector<bool> known;              /* at the block's end: does a register have the counter's value? */
    std::vector<bool> wanted;             /* at the block's beginning: will somebody read the counter? */
};

counter_flow::counter_flow(function *f, tree c, bool (*n)(gimple *))
    : fun(f), counter(c), needs_counter(n), first(last_basic_block_for_fn(f), NOTHING), last(first),
      known(first.size(), true), wanted(first.size(), false)
{
    known[ENTRY_BLOCK] = false;
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun)
        for (gimple_stmt_iterator i = gsi_start_bb(bb); !gsi_end_p(i); gsi_next(&i))
            if (counter_use use = use_in(gsi_stmt(i))) {
                last[bb->index] = use;
                first[bb->index] = first[bb->index] ? first[bb->index] : use;
            }
}

counter_use counter_flow::use_in(gimple *stmt) const
{
    if (gimple_assign_single_p(stmt)) {
        if (gimple_assign_lhs(stmt) == counter)
            return STORE;
        return gimple_assign_rhs1(stmt) == counter ? LOAD : NOTHING;
    }
    bool shows = gimple_code(stmt) == GIMPLE_ASM || gimple_code(stmt) == GIMPLE_RETURN || needs_counter(stmt);
    return shows ? SHOW : NOTHING;
}

bool counter_flow::is_known_before(basic_block bb) const
{
    edge e;
    edge_iterator ei;
    FOR_EACH_EDGE (e, ei, bb->preds)
        if (!known[e->src->index])
            return false;
    return true;
}

bool counter_flow::is_wanted_behind(basic_block bb) const
{
    edge e;
    edge_iterator ei;
    FOR_EACH_EDGE (e, ei, bb->succs)
        if (wanted[e->dest->index])
            return true;
    return false;
}

void counter_flow::replace_loads(basic_block bb, tree now)
{
    bool is_known = is_known_before(bb);
    for (gimple_stmt_iterator i = gsi_start_bb(bb); !gsi_end_p(i); gsi_next(&i)) {
        gimple *stmt = gsi_stmt(i);
        counter_use use = use_in(stmt);
        if (use == LOAD && is_known) {
            gimple_assign_set_rhs1(stmt, now);
            update_stmt(stmt);
        } else if (use == LOAD || use == STORE) {
            tree value = use == LOAD ? gimple_assign_lhs(stmt) : gimple_assign_rhs1(stmt);
            gsi_insert_after(&i, gimple_build_assign(now, value), GSI_NEW_STMT);
        }
        is_known = use ? use != SHOW : is_known;
    }
}

void counter_flow::replace_loads()
{
    basic_block bb;
    for (bool again = true; again;) {
        again = false;
        FOR_EACH_BB_FN (bb, fun) {
            counter_use use = last[bb->index];
            bool now = use ? use != SHOW : is_known_before(bb);
            again = again || now != known[bb->index];
            known[bb->index] = now;
        }
    }
    tree now = create_tmp_reg(TREE_TYPE(counter), "left");
    FOR_EACH_BB_FN (bb, fun)
        replace_loads(bb, now);
    update_ssa(TODO_update_ssa);
}

void counter_flow::remove_stores(basic_block bb)
{
    bool is_wanted = is_wanted_behind(bb);
    for (gimple_stmt_iterator i = gsi_last_bb(bb); !gsi_end_p(i);) {
        gimple_stmt_iterator here = i;
        gimple *stmt = gsi_stmt(i);
        counter_use use = use_in(stmt);
        gsi_prev(&i);
        if (use == STORE && !is_wanted) {
            unlink_stmt_vdef(stmt);
            gsi_remove(&here, true);
            release_defs(stmt);
        }
        is_wanted = use ? use != STORE : is_wanted;
    }
}

void counter_flow::remove_stores()
{
    basic_block bb;
    for (bool again = true; again;) {
        again = false;
        FOR_EACH_BB_REVERSE_FN(bb, fun)
        {
            counter_use use = first[bb->index];
            bool now = use ? use != STORE : is_wanted_behind(bb);
            again = again || now != wanted[bb->index];
            wanted[bb->index] = now;
        }
    }
    FOR_EACH_BB_FN (bb, fun)
        remove_stores(bb);
}
} // namespace

void counter_flow_clean(function *fun, tree counter, bool (*needs_counter)(gimple *))
{
    counter_flow(fun, counter, needs_counter).replace_loads();
    counter_flow(fun, counter, needs_counter).remove_stores();
}
