/* lookahead.cc - see lookahead.h. */
#include "counting/lookahead.h"
#include "counting/call_free.h"
#include "base/costs.h"
#include "../contract/program_image.h"
#include "counting/leaf_charge.h"
#include "counting/trip_count.h"
#include "tree-ssa-loop-ivopts.h"
#include <algorithm>

namespace
{
/* A shorter lookahead is not worth its code: 10 us of a 40 MHz processor. */
const int64_t least_lookahead = 400 * NXC_UNITS_PER_CLOCK;
/* Nor is the variable of a loop with cheaper trips, unless it is a polled version, which runs seldom. */
const int64_t least_trip_units = 20 * NXC_UNITS_PER_CLOCK;
const int64_t most_units = INT64_MAX / 64; /* no counter is ever greater */
const int64_t most_times = 1 << 14;        /* an inner loop adds at most so many times the rest of the trip */
const size_t most_external = 2;            /* functions of other files that a loop calls */

/* What the statements of a block, or of a loop, do besides computing. */
struct effects {
    bool calls = false;         /* there is a call that the simulator may serve */
    bool callees_poll = false;  /* a call-free function with polls is called */
    std::vector<tree> external; /* functions of other files that are called, each once */

    bool any_call() const { return calls || !external.empty(); }
    void add_external(tree function)
    {
        if (std::find(external.begin(), external.end(), function) == external.end())
            external.push_back(function);
    }
    void add(const effects &d)
    {
        calls |= d.calls, callees_poll |= d.callees_poll;
        for (tree function : d.external)
            add_external(function);
    }
};

struct block_cost : effects {
    int64_t units = 0; /* in all */
    int64_t first = 0; /* up to the first call */
};

struct loop_cost : effects {
    int64_t trips = 0; /* the least trip count, whenever the loop is entered */
    int64_t least = 0; /* units of the cheapest trip that goes back, if it makes no call */
    int64_t added = 0; /* units of so many trips */
    /* `remaining`, where a trip begins, and later in the trip, when it is that of the next trip already;
     * NULL: the loop has none. exact: it is 0 in the last trip. */
    tree before = NULL_TREE, after = NULL_TREE;
    bool exact = false;
};

typedef std::map<basic_block, int64_t> path_units; /* of the cheapest path from each block's beginning */

class lookahead_analysis
{
  public:
    lookahead_analysis(bitmap c, const std::set<basic_block> &s, std::set<gimple *> &o)
        : poll_blocks(c), polled(s), added(o)
    {
    }
    std::map<basic_block, lookahead> run();

  private:
    void cost_blocks();
    void scan_loop(class loop *loop);
    bool is_of_last(class loop *loop, edge e);
    int64_t cheapest_path(class loop *loop, basic_block bb, std::map<basic_block, int64_t> &known);
    int64_t units_of_loop_entered(edge e);
    int64_t path_from(basic_block bb, class loop *within, path_units &known);
    const path_units &paths_to_end(class loop *within);
    int64_t path(basic_block bb, class loop *last, class loop *within);
    void accept_call_free();
    bool is_worth_a_variable(class loop *loop);
    tree append_inner(gimple_seq *seq, class loop *outer, class loop *inner);
    tree append_trip_units(gimple_seq *seq, class loop *loop);
    tree append_units(gimple_seq *seq, class loop *loop, tree trip_units);
    void keep(class loop *loop);
    lookahead at(basic_block bb);

    bitmap poll_blocks;
    const std::set<basic_block> &polled;
    std::set<gimple *> &added;
    std::map<basic_block, block_cost> blocks;
    std::map<class loop *, loop_cost> loops;
    std::vector<basic_block> post_order;
    std::map<class loop *, path_units> paths; /* results of paths_to_end */
};

/* --- calls ---------------------------------------------------------------------------------------------- */

/* Adds a call to the effects; returns the units of the function called. */
int64_t add_call(gcall *call, effects &d)
{
    tree callee = gimple_call_fndecl(call);
    if (costs_call_is_uncounted(call) || leaf_charge_is_call(call))
        return leaf_charge_cost(call);
    if (const call_free_function *known = call_free_find(callee)) {
        d.callees_poll |= known->polls;
        return known->units;
    }
    if (call_free_is_external(callee))
        d.add_external(callee);
    else
        d.calls = true;
    return 0;
}

/* Computes the block_cost of each block. */
void lookahead_analysis::cost_blocks()
{
    basic_block bb;
    FOR_EACH_BB_FN (bb, cfun) {
        block_cost &c = blocks[bb];
        for (gimple_stmt_iterator gsi = gsi_start_nondebug_bb(bb); !gsi_end_p(gsi); gsi_next_nondebug(&gsi)) {
            gimple *stmt = gsi_stmt(gsi);
            if (added.count(stmt))
                continue;
            int64_t units = costs_of(stmt);
            if (gcall *call = dyn_cast<gcall *>(stmt))
                units += add_call(call, c);
            c.calls |= gimple_code(stmt) == GIMPLE_ASM;
            c.units = std::min(most_units, c.units + units);
            if (!c.any_call())
                c.first = c.units;
        }
    }
}

/* --- paths ---------------------------------------------------------------------------------------------- */

/* The units of the loop that an edge enters, 0 if it enters none. */
int64_t lookahead_analysis::units_of_loop_entered(edge e)
{
    class loop *loop = e->dest->loop_father;
    return e->dest == loop->header && !flow_bb_inside_loop_p(loop, e->src) ? loops[loop].added : 0;
}

/* The trip in which a variable with a constant step becomes equal to a constant, for an edge that is taken
 * only then. GCC computes this only for tests that every trip makes. */
int64_t trips_until_equal(class loop *loop, edge e)
{
    gcond *test = safe_dyn_cast<gcond *>(last_statement(e->src));
    affine_iv iv;
    if (!test || gimple_cond_code(test) != (e->flags & EDGE_TRUE_VALUE ? EQ_EXPR : NE_EXPR) ||
        !tree_fits_shwi_p(gimple_cond_rhs(test)) ||
        !simple_iv(loop, loop, gimple_cond_lhs(test), &iv, false) || !tree_fits_shwi_p(iv.base) ||
        !tree_fits_shwi_p(iv.step) || integer_zerop(iv.step))
        return 0;
    int64_t distance, begin = tree_to_shwi(iv.base), step = tree_to_shwi(iv.step);
    if (__builtin_sub_overflow(tree_to_shwi(gimple_cond_rhs(test)), begin, &distance) || distance % step ||
        distance / step < 0)
        return 0;
    return distance / step;
}

/* How often a loop goes back at least before it may take an edge, if that is a constant; else 0. */
int64_t trips_before(class loop *loop, edge e)
{
    tree_niter_desc n;
    if (e->flags & EDGE_COMPLEX)
        return 0;
    if (number_of_iterations_exit_assumptions(loop, e, &n, NULL, false) && integer_onep(n.assumptions) &&
        integer_zerop(n.may_be_zero) && tree_fits_shwi_p(n.niter))
        return tree_to_shwi(n.niter);
    return trips_until_equal(loop, e);
}

/* How often a loop goes back at least before it takes an exit: also by the edges that lead to the exit. */
int64_t trips_before_exit(class loop *loop, edge exit)
{
    int64_t most = trips_before(loop, exit);
    for (basic_block bb = exit->src; bb != loop->header; bb = get_immediate_dominator(CDI_DOMINATORS, bb))
        if (single_pred_p(bb))
            most = std::max(most, trips_before(loop, single_pred_edge(bb)));
    return most;
}

/* The least trip count. */
int64_t least_trips(class loop *loop)
{
    int64_t least = INT64_MAX;
    for (edge exit : get_loop_exit_edges(loop))
        least = std::min(least, trips_before_exit(loop, exit));
    return least == INT64_MAX ? 0 : least;
}

/* Is an edge taken in the last trip only, which the least trip count does not include? */
bool lookahead_analysis::is_of_last(class loop *loop, edge e)
{
    int64_t trips = loops[loop].trips;
    return trips > 0 && !single_succ_p(e->src) && e->src->loop_father == loop &&
           trips_before(loop, e) >= trips;
}

/* The units of the cheapest path from the beginning of a trip to the end of a block, for a trip that goes
 * back. */
int64_t lookahead_analysis::cheapest_path(class loop *loop, basic_block bb,
                                          std::map<basic_block, int64_t> &known)
{
    auto found = known.find(bb);
    if (found != known.end())
        return found->second;
    int64_t before = bb == loop->header ? 0 : most_units;
    edge e;
    edge_iterator i;
    if (bb != loop->header)
        FOR_EACH_EDGE (e, i, bb->preds)
            if (!dominated_by_p(CDI_DOMINATORS, e->src, bb) && !is_of_last(loop, e))
                before = std::min(before, cheapest_path(loop, e->src, known) + units_of_loop_entered(e));
    return known[bb] = std::min(most_units, before + blocks[bb].units);
}

/* Computes a loop_cost, for all but the variable. Inner loops come before outer ones. */
void lookahead_analysis::scan_loop(class loop *loop)
{
    loop_cost &l = loops[loop];
    basic_block *body = get_loop_body(loop);
    for (unsigned i = 0; i < loop->num_nodes; i++) {
        l.add(blocks[body[i]]);
        l.calls |= (body[i]->flags & BB_IRREDUCIBLE_LOOP) != 0;
    }
    free(body);
    if (l.calls)
        return;
    l.trips = least_trips(loop);
    std::map<basic_block, int64_t> known;
    l.least = cheapest_path(loop, loop->latch, known);
    if (!l.any_call())
        l.added = l.trips < most_units / (l.least + 1) ? l.trips * l.least : most_units;
}

/* The units of the cheapest path from a block's beginning, by what is known of its successors. */
int64_t lookahead_analysis::path_from(basic_block bb, class loop *within, path_units &known)
{
    const block_cost &c = blocks[bb];
    if (within ? bb == within->latch : c.any_call() || !EDGE_COUNT(bb->succs))
        return within ? c.units : c.first;
    int64_t rest = most_units;
    edge e;
    edge_iterator i;
    FOR_EACH_EDGE (e, i, bb->succs)
        if (!within || (e->dest != within->header && flow_bb_inside_loop_p(within, e->dest)))
            rest = std::min(rest, known[e->dest] + units_of_loop_entered(e));
    return std::min(most_units, c.units + rest);
}

/* The cheapest paths from all blocks of a loop to the end of a trip; within NULL: from all blocks to the next
 * call, or to the function's end. Bellman-Ford: paths become shorter until none does. */
const path_units &lookahead_analysis::paths_to_end(class loop *within)
{
    path_units &known = paths[within];
    if (!known.empty())
        return known;
    std::vector<basic_block> order;
    for (basic_block bb : post_order)
        if (!within || flow_bb_inside_loop_p(within, bb))
            order.push_back(bb), known[bb] = most_units;
    known[EXIT_BLOCK_PTR_FOR_FN(cfun)] = 0;
    for (bool again = true; again;) {
        again = false;
        for (basic_block bb : order) {
            int64_t units = path_from(bb, within, known);
            again |= units < known[bb];
            known[bb] = units;
        }
    }
    return known;
}

/* Records the function as call-free if it is. */
void lookahead_analysis::accept_call_free()
{
    for (auto &b : blocks)
        if (b.second.any_call())
            return;
    call_free_add(
        {paths_to_end(NULL).at(single_succ(ENTRY_BLOCK_PTR_FOR_FN(cfun))), !bitmap_empty_p(poll_blocks)});
}

/* --- remaining trips ------------------------------------------------------------------------------------ */

/* A precharged loop does not poll; nor do its inner loops. */
bool lookahead_analysis::is_worth_a_variable(class loop *loop)
{
    const loop_cost &l = loops[loop];
    return !l.calls && l.external.size() <= most_external && bitmap_bit_p(poll_blocks, loop->header->index) &&
           l.least >= (polled.count(loop->header) ? 1 : least_trip_units);
}

/* Appends the trip count, or 0 if it is limit or more, or not known. */
tree append_known(gimple_seq *seq, class loop *loop, const tree_niter_desc &n, int64_t limit)
{
    tree trips = trip_count_append(seq, loop, n, limit);
    tree known = gimple_build(seq, LT_EXPR, boolean_type_node, trips, units_constant(limit));
    return gimple_build(seq, COND_EXPR, units_type(), known, trips, units_constant(0));
}

/* Appends the units that an inner loop adds to the cheapest trip of the outer one. NULL: they are not known
 * where the outer loop is entered. */
tree lookahead_analysis::append_inner(gimple_seq *seq, class loop *outer, class loop *inner)
{
    const loop_cost &l = loops[inner];
    tree_niter_desc n;
    if (l.trips || !l.least || !trip_count_is_known(inner, &n))
        return NULL_TREE;
    for (tree *t : {&n.niter, &n.may_be_zero, &n.assumptions})
        if (!expr_invariant_in_loop_p(outer, *t = expand_simple_operations(*t)))
            return NULL_TREE;
    const int64_t limit = most_times * loops[outer].least / l.least;
    return gimple_build(seq, MULT_EXPR, units_type(), append_known(seq, inner, n, limit),
                        units_constant(l.least));
}

/* The loop within `outer` to which all paths behind an edge lead; NULL: there is none. */
class loop *loop_behind(edge e, class loop *outer)
{
    basic_block bb = e->dest;
    while (bb->loop_father == outer && bb != outer->latch && single_succ_p(bb))
        bb = single_succ(bb);
    class loop *loop = bb->loop_father;
    return loop_outer(loop) == outer && bb == loop->header ? loop : NULL;
}

/* The block, in each trip of the outer loop that goes back, from which paths lead to the inner loop or past
 * it. */
basic_block fork_before(class loop *outer, class loop *inner)
{
    basic_block bb = inner->header;
    while (!dominated_by_p(CDI_DOMINATORS, outer->latch, bb))
        bb = get_immediate_dominator(CDI_DOMINATORS, bb);
    return bb;
}

/* Appends the units of a trip that goes back: the cheapest trip, and what inner loops add. Of two inner loops
 * between which a trip chooses, the cheaper one adds: loop_precharge.h makes two loops of one. */
tree lookahead_analysis::append_trip_units(gimple_seq *seq, class loop *loop)
{
    const int64_t least = loops[loop].least;
    tree sum = units_constant(least);
    for (class loop *inner = least < most_units / most_times ? loop->inner : NULL; inner;
         inner = inner->next) {
        basic_block fork = fork_before(loop, inner);
        tree units = NULL_TREE;
        if (fork == inner->header) {
            units = append_inner(seq, loop, inner);
        } else if (EDGE_COUNT(fork->succs) == 2 && inner == loop_behind(EDGE_SUCC(fork, 0), loop)) {
            class loop *other = loop_behind(EDGE_SUCC(fork, 1), loop);
            tree one = other ? append_inner(seq, loop, inner) : NULL_TREE;
            tree two = one ? append_inner(seq, loop, other) : NULL_TREE;
            units = two ? gimple_build(seq, MIN_EXPR, units_type(), one, two) : NULL_TREE;
        }
        if (units)
            sum = gimple_build(seq, PLUS_EXPR, units_type(), sum, units);
    }
    return sum;
}

/* Appends the units of all trips where a loop is entered; NULL: not known. */
tree lookahead_analysis::append_units(gimple_seq *seq, class loop *loop, tree trip_units)
{
    const loop_cost &l = loops[loop];
    int64_t limit = most_units / l.least;
    tree zero = units_constant(0), trips;
    tree_niter_desc n;
    if (!tree_fits_shwi_p(trip_units))
        limit /= most_times;
    if (l.trips)
        trips = units_constant(std::min(limit, l.trips));
    else if (trip_count_is_known(loop, &n))
        trips = append_known(seq, loop, n, limit);
    else
        return NULL_TREE;
    tree units = gimple_build(seq, MULT_EXPR, units_type(), trips, trip_units);
    if (!l.external.empty())
        units =
            gimple_build(seq, COND_EXPR, units_type(), call_free_append_all(seq, l.external), units, zero);
    return units;
}

/* Makes the variable `remaining` of a loop, if it is worth its code. */
void lookahead_analysis::keep(class loop *loop)
{
    if (!is_worth_a_variable(loop))
        return;
    gimple_seq seq = NULL;
    tree trip_units = append_trip_units(&seq, loop), units = append_units(&seq, loop, trip_units);
    if (!units || integer_zerop(units))
        return;
    tree step = gimple_build(&seq, NEGATE_EXPR, units_type(), trip_units);
    for (gimple_stmt_iterator gsi = gsi_start(seq); !gsi_end_p(gsi); gsi_next(&gsi))
        added.insert(gsi_stmt(gsi));
    if (seq)
        gsi_insert_seq_on_edge_immediate(loop_preheader_edge(loop), seq);
    loop_cost &l = loops[loop];
    gimple_stmt_iterator begin = gsi_after_labels(loop->header);
    create_added_iv(units, step, loop, &begin, &l.before, &l.after);
    added.insert(SSA_NAME_DEF_STMT(l.after));
    l.exact = tree_fits_shwi_p(trip_units) && l.external.empty() &&
              (!l.trips || trip_count_constant(loop) == l.trips);
}

/* The units of the cheapest path from bb to the end of a trip of `within`, or to the next call, without the
 * remaining trips of those loops around bb, up to `last` exclusive, that have a variable. If bb is not the
 * header of such a loop, either no trip is to come, or the path goes to the end of bb's trip and through one
 * trip more: the variable has one trip too many then. */
int64_t lookahead_analysis::path(basic_block bb, class loop *last, class loop *within)
{
    int64_t least = paths_to_end(within).at(bb);
    for (class loop *loop = bb->loop_father; loop != last; loop = loop_outer(loop))
        if (loops[loop].before && bb != loop->header)
            least = std::min(least, path(bb, loop, loop) - loops[loop].least +
                                        paths_to_end(within).at(loop->header));
    return least;
}

/* The lookahead at the beginning of bb. */
lookahead lookahead_analysis::at(basic_block bb)
{
    lookahead p;
    class loop *loop = bb->loop_father;
    for (; loop_outer(loop) && !loops[loop].calls; loop = loop_outer(loop)) {
        const loop_cost &l = loops[loop];
        if (!l.before)
            continue;
        bool begins = bb == loop->header;
        p.loops.push_back({begins ? l.before : l.after, begins ? 0 : l.least, !l.exact});
        p.callees_poll = p.callees_poll || (begins && l.callees_poll && l.least >= least_lookahead);
    }
    p.least = path(bb, loop, NULL);
    return p;
}

std::map<basic_block, lookahead> lookahead_analysis::run()
{
    loop_optimizer_init(LOOPS_NORMAL | LOOPS_HAVE_RECORDED_EXITS);
    calculate_dominance_info(CDI_DOMINATORS);
    scev_initialize();
    cost_blocks();
    std::vector<int> order(n_basic_blocks_for_fn(cfun));
    order.resize(post_order_compute(order.data(), false, false));
    for (int index : order)
        post_order.push_back(BASIC_BLOCK_FOR_FN(cfun, index));
    for (auto loop : loops_list(cfun, LI_FROM_INNERMOST))
        scan_loop(loop);
    accept_call_free();
    for (auto loop : loops_list(cfun, 0))
        keep(loop);
    std::map<basic_block, lookahead> found;
    basic_block bb;
    FOR_EACH_BB_FN (bb, cfun) {
        if (!bitmap_bit_p(poll_blocks, bb->index))
            continue;
        lookahead p = at(bb);
        if (p.least >= least_lookahead || !p.loops.empty())
            found[bb] = p;
    }
    scev_finalize();
    loop_optimizer_finalize();
    return found;
}
} // namespace

std::map<basic_block, lookahead> lookahead_find(bitmap poll_blocks, const std::set<basic_block> &polled,
                                                std::set<gimple *> &added)
{
    return lookahead_analysis(poll_blocks, polled, added).run();
}

void lookahead_append(gimple_seq *seq, const lookahead &p, int64_t charged, tree word, tree left)
{
    tree now = make_ssa_name(units_type()), before = make_ssa_name(units_type());
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(now, left));
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(before, word));
    tree end = gimple_build(seq, PLUS_EXPR, units_type(), now, units_constant(charged - p.least));
    for (const remaining_trips &r : p.loops) {
        tree more = gimple_build(seq, PLUS_EXPR, units_type(), r.remaining, units_constant(r.add));
        if (r.at_least_0)
            more = gimple_build(seq, MAX_EXPR, units_type(), more, units_constant(0));
        end = gimple_build(seq, MINUS_EXPR, units_type(), end, more);
    }
    end = gimple_build(seq, MIN_EXPR, units_type(), before, end);
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(word, end));
}
