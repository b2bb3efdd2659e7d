/* loop_precharge.cc - see loop_precharge.h. */
#include "counting/loop_precharge.h"
#include "counting/cache.h"
#include "base/costs.h"
#include "counting/leaf_charge.h"
#include "counting/trip_count.h"

namespace
{
/* A poll costs little in a longer body or inner loop. */
const unsigned longest_body = 100; /* statements */
const int64_t most_inner_trips = 32;

class precharging
{
  public:
    precharging(bool (*l)(gimple *), bitmap c) : needs_counter(l), poll_blocks(c) {}
    precharge_plan run();

  private:
    bool is_plain(basic_block bb, unsigned *statements) const;
    bool is_plain(class loop *loop, unsigned *statements) const;
    void scan_loops(class loop *first);
    bool prepare(class loop *loop);
    void divide(class loop *loop, precharged_loop &p);

    bool (*needs_counter)(gimple *);
    bitmap poll_blocks;
    precharge_plan result;
    std::vector<class loop *> chosen; /* those of result.loops, in the same order */
};

/* --- what a loop costs ---------------------------------------------------------------------------------- */

/* Is the block's cost known, and does no statement need the counter? */
bool precharging::is_plain(basic_block bb, unsigned *statements) const
{
    if (bb->flags & BB_IRREDUCIBLE_LOOP)
        return false;
    for (gimple_stmt_iterator gsi = gsi_start_nondebug_bb(bb); !gsi_end_p(gsi); gsi_next_nondebug(&gsi)) {
        gimple *stmt = gsi_stmt(gsi);
        gcall *call = dyn_cast<gcall *>(stmt);
        const call_cost *price;
        if (needs_counter(stmt) || gimple_code(stmt) == GIMPLE_ASM ||
            (call && costs_of_call(call, &price)))
            return false;
        ++*statements;
    }
    return true;
}

/* The loop's own blocks, without those of inner loops. */
std::vector<basic_block> blocks_outside_inner_loops(class loop *loop)
{
    basic_block *body = get_loop_body(loop);
    std::vector<basic_block> added;
    for (unsigned i = 0; i < loop->num_nodes; i++)
        if (body[i]->loop_father == loop)
            added.push_back(body[i]);
    free(body);
    return added;
}

bool precharging::is_plain(class loop *loop, unsigned *statements) const
{
    for (class loop *inner = loop->inner; inner; inner = inner->next) {
        int64_t trips = trip_count_constant(inner);
        if (trips < 0 || trips > most_inner_trips || !is_plain(inner, statements))
            return false;
    }
    for (basic_block bb : blocks_outside_inner_loops(loop))
        if (!is_plain(bb, statements))
            return false;
    return *statements <= longest_body;
}

int64_t cost_of_block(basic_block bb)
{
    int64_t sum = 0;
    for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi))
        sum += costs_of(gsi_stmt(gsi)) + leaf_charge_cost(gsi_stmt(gsi)) + cache_most(gsi_stmt(gsi));
    return sum;
}

/* The units of a trip that runs all blocks, and misses a simulated cache at each access. */
int64_t costliest_trip(class loop *loop)
{
    int64_t sum = 0;
    for (class loop *inner = loop->inner; inner; inner = inner->next)
        sum += costliest_trip(inner) * (trip_count_constant(inner) + 1);
    for (basic_block bb : blocks_outside_inner_loops(loop))
        sum += cost_of_block(bb);
    return sum;
}

/* Lists the blocks that every trip runs. outer: how often this inner loop is entered; NULL: it is the
 * outermost loop. */
void list_blocks(class loop *loop, const precharged_block *outer, std::vector<precharged_block> &blocks)
{
    int64_t trips = outer ? trip_count_constant(loop) : 0;
    auto runs = [&](basic_block bb) -> precharged_block {
        int64_t each = dominated_by_p(CDI_DOMINATORS, loop->latch, bb);
        int64_t last = dominated_by_p(CDI_DOMINATORS, single_exit(loop)->src, bb);
        if (!outer)
            return {bb, each, last};
        return {bb, outer->each * (trips * each + last), outer->last * (trips * each + last)};
    };
    for (basic_block bb : blocks_outside_inner_loops(loop)) {
        precharged_block block = runs(bb);
        if (block.each || block.last)
            blocks.push_back(block);
    }
    for (class loop *inner = loop->inner; inner; inner = inner->next) {
        precharged_block block = runs(inner->header);
        list_blocks(inner, &block, blocks);
    }
}

/* --- making the polled versions ------------------------------------------------------------------------- */

/* Plans the charge of a loop, and computes the trip count where the loop is entered. False: the loop stays as
 * it is. */
bool precharging::prepare(class loop *loop)
{
    unsigned statements = 0;
    tree_niter_desc n;
    if (!trip_count_is_known(loop, &n) || integer_zerop(n.niter) || !optimize_loop_for_speed_p(loop) ||
        !can_duplicate_loop_p(loop) || !is_plain(loop, &statements))
        return false;
    precharged_loop p = {};
    p.most = costliest_trip(loop);
    if (!p.most)
        return false;
    list_blocks(loop, NULL, p.blocks);
    gimple_seq seq = NULL;
    p.limit = INT64_MAX / 2 / p.most; /* no counter is ever greater */
    p.trips = trip_count_append(&seq, loop, n, p.limit);
    for (gimple_stmt_iterator gsi = gsi_start(seq); !gsi_end_p(gsi); gsi_next(&gsi))
        result.added.insert(gsi_stmt(gsi));
    if (seq)
        gsi_insert_seq_on_edge_immediate(loop_preheader_edge(loop), seq);
    result.loops.push_back(p);
    chosen.push_back(loop);
    return true;
}

/* Plans the outermost loops that can be precharged. */
void precharging::scan_loops(class loop *first)
{
    for (class loop *loop = first; loop; loop = loop->next)
        if (!prepare(loop))
            scan_loops(loop->inner);
}

/* Copies a loop: the copy is the polled version. */
void precharging::divide(class loop *loop, precharged_loop &p)
{
    basic_block test;
    profile_probability likely = profile_probability::very_likely(), unlikely = likely.invert();
    unsigned blocks = loop->num_nodes;
    basic_block *body = get_loop_body(loop);
    class loop *copy = loop_version(loop, boolean_true_node, &test, likely, unlikely, likely, unlikely, true);
    for (unsigned i = 0; i < blocks; i++)
        if (bitmap_clear_bit(poll_blocks, body[i]->index))
            bitmap_set_bit(poll_blocks, get_bb_copy(body[i])->index);
    free(body);
    p.test = as_a<gcond *>(last_statement(test));
    p.first = loop_preheader_edge(loop)->src;
    result.polled.insert(copy->header);
    result.added.insert(p.test);
}

precharge_plan precharging::run()
{
    loop_optimizer_init(LOOPS_NORMAL | LOOPS_HAVE_RECORDED_EXITS);
    rewrite_into_loop_closed_ssa(NULL, TODO_update_ssa);
    calculate_dominance_info(CDI_DOMINATORS);
    scev_initialize();
    scan_loops(get_loop(cfun, 0)->inner);
    scev_finalize();
    initialize_original_copy_tables();
    for (size_t i = 0; i < chosen.size(); i++)
        divide(chosen[i], result.loops[i]);
    free_original_copy_tables();
    update_ssa(TODO_update_ssa);
    loop_optimizer_finalize();
    return result;
}
} // namespace

precharge_plan loop_precharge_run(bool (*needs_counter)(gimple *), bitmap poll_blocks)
{
    return precharging(needs_counter, poll_blocks).run();
}
