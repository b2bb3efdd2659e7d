/* idle_loops.cc - see idle_loops.h. */
#include "counting/idle_loops.h"
#include "base/costs.h"
#include "counting/leaf_charge.h"

namespace
{
bool costs_nothing(basic_block bb, bool (*needs_counter)(gimple *))
{
    for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi))
        if (costs_of(gsi_stmt(gsi)) || leaf_charge_cost(gsi_stmt(gsi)) || needs_counter(gsi_stmt(gsi)))
            return false;
    return true;
}

/* Does a path through blocks that cost nothing lead from bb back to bb? */
bool is_on_cycle(basic_block bb, bitmap costless)
{
    auto_bitmap seen;
    std::vector<basic_block> open{bb};
    while (!open.empty()) {
        basic_block from = open.back();
        open.pop_back();
        edge e;
        edge_iterator ei;
        FOR_EACH_EDGE (e, ei, from->succs) {
            if (e->dest == bb)
                return true;
            if (bitmap_bit_p(costless, e->dest->index) && bitmap_set_bit(seen, e->dest->index))
                open.push_back(e->dest);
        }
    }
    return false;
}
} // namespace

void idle_loops_find(function *fun, bool (*needs_counter)(gimple *), bitmap poll_blocks, bitmap idle)
{
    auto_bitmap costless;
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun)
        if (costs_nothing(bb, needs_counter))
            bitmap_set_bit(costless, bb->index);
    FOR_EACH_BB_FN (bb, fun)
        if (bitmap_bit_p(poll_blocks, bb->index) && bitmap_bit_p(costless, bb->index) &&
            is_on_cycle(bb, costless))
            bitmap_set_bit(idle, bb->index);
}
